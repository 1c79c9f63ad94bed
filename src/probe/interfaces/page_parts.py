"""What all pages load: colours and type, and the icon that they don't have."""

from __future__ import annotations

from starlette.requests import Request
from starlette.responses import Response

from probe.report.rendering import joined


def base_css(_: Request) -> Response:
    """Colours and type as in reports."""
    return Response(str(joined("report", ("base.css",))), media_type="text/css")


def no_icon(_: Request) -> Response:
    """Browsers ask for one whatever the page says."""
    return Response(status_code=204)
