"""The two pages, and the files that they load."""

from __future__ import annotations

from functools import partial
from pathlib import Path

import jinja2
from starlette.requests import Request
from starlette.responses import HTMLResponse, RedirectResponse, Response
from starlette.routing import BaseRoute, Mount, Route
from starlette.staticfiles import StaticFiles

from probe.interfaces.human.names import LONGEST, BadName, name_of
from probe.interfaces.human.words import RULES
from probe.report.rendering import joined
from probe.toolshed.tools import tool_schemas
from probe.types import PictureScale

_HERE = Path(__file__).parent


def page_routes(scale: PictureScale) -> list[BaseRoute]:
    """The door, where one gives a name; the seat; styles and scripts.

    Args:
        scale: Of the pictures that the tools' texts speak of.
    """
    return [
        Route("/", _door),
        Route("/seat", partial(_seat, scale), name="seat"),
        Route("/base.css", _base),
        Route("/favicon.ico", _no_icon),
        Mount("/static", StaticFiles(directory=_HERE / "static")),
    ]


def _door(_: Request) -> Response:
    return _page("door.html", {"trouble": None, "said": ""})


def _seat(scale: PictureScale, request: Request) -> Response:
    said = request.query_params.get("name", "")
    try:
        name = name_of(said)
    except BadName as error:
        return _page("door.html", {"trouble": str(error), "said": said[: 2 * LONGEST]}, 400)
    if name != said:
        return RedirectResponse(request.url_for("seat").include_query_params(name=name))
    return _page("seat.html", {"name": name, "tools": tool_schemas(scale)})


def _base(_: Request) -> Response:
    """Colours and type as in reports."""
    return Response(str(joined("report", ("base.css",))), media_type="text/css")


def _no_icon(_: Request) -> Response:
    """Browsers ask for one whatever the page says."""
    return Response(status_code=204)


def _page(template: str, values: dict[str, object], status: int = 200) -> Response:
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(_HERE / "templates"),
        autoescape=True,
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    filled = environment.get_template(template).render(values | {"rules": RULES})
    return HTMLResponse(filled, status)
