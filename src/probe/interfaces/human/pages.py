"""The two pages, and the files that they load."""

from __future__ import annotations

from collections.abc import Mapping
from functools import partial
from pathlib import Path

import jinja2
from starlette.requests import Request
from starlette.responses import HTMLResponse, RedirectResponse, Response
from starlette.routing import BaseRoute, Mount, Route
from starlette.staticfiles import StaticFiles

from probe.interfaces.human.names import LONGEST, BadName, name_of
from probe.interfaces.human.words import RULES
from probe.interfaces.page_parts import base_css, no_icon
from probe.toolshed.tools import tool_schemas
from probe.types import PictureScale

_HERE = Path(__file__).parent


def page_routes(scale: PictureScale, practice: int) -> list[BaseRoute]:
    """The door, where one gives a name; the seat; styles and scripts.

    Args:
        scale: Of the pictures that the tools' texts speak of.
        practice: How many questions there are to practise on.
    """
    return [
        Route("/", partial(_door, practice)),
        Route("/seat", partial(_seat, scale, practice), name="seat"),
        Route("/base.css", base_css),
        Route("/favicon.ico", no_icon),
        Mount("/static", StaticFiles(directory=_HERE / "static")),
    ]


def _door(practice: int, _: Request) -> Response:
    return _page("door.html", {"trouble": None, "said": "", "practice": practice})


def _seat(scale: PictureScale, practice: int, request: Request) -> Response:
    said = request.query_params.get("name", "")
    try:
        name = name_of(said)
    except BadName as error:
        values = {"trouble": str(error), "said": said[: 2 * LONGEST], "practice": practice}
        return _page("door.html", values, 400)
    practises = request.query_params.get("practice") == "1"
    real = request.url_for("seat").include_query_params(name=name)
    if name != said:
        return RedirectResponse(real.include_query_params(practice="1") if practises else real)
    at_seat = {"name": name, "practice": practises, "tools": tool_schemas(scale)}
    return _page("seat.html", {**at_seat, "real": f"{real.path}?{real.query}"})


def _page(template: str, values: Mapping[str, object], status: int = 200) -> Response:
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(_HERE / "templates"),
        autoescape=True,
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    filled = environment.get_template(template).render({**values, "rules": RULES})
    return HTMLResponse(filled, status)
