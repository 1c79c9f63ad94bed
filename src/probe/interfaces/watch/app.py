"""A run as it happens: how far it is, and each table's question, newest picture, calls and texts.

Changes nothing: there is no request that does.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import FileResponse, JSONResponse, Response
from starlette.routing import Mount, Route
from starlette.staticfiles import StaticFiles

from probe.interfaces.human.guard import guards
from probe.interfaces.page_parts import base_css, no_icon
from probe.interfaces.watch.progress import RecordCount
from probe.runs.live import LiveDocument

_HERE = Path(__file__).parent


@dataclass(frozen=True)
class WatchedRun:
    """What the page shows.

    Attributes:
        suite: Name of the suite.
        agent: Who acts, in words.
        total: Episodes that there are to be.
        count: Says how many there are.
        tables: Folder in which workers write down what happens; see probe.runs.live.
    """

    suite: str
    agent: str
    total: int
    count: RecordCount
    tables: Path


def app_of(run: WatchedRun) -> Starlette:
    """The application."""

    def state(_: Request) -> Response:
        return JSONResponse(_state(run))

    def picture(request: Request) -> Response:
        number = request.query_params.get("table", "")
        path = run.tables / f"{number}.jpg"
        if not number.isdecimal() or not path.exists():
            return Response(status_code=404)
        return Response(path.read_bytes(), media_type="image/jpeg")

    return Starlette(
        routes=[
            Route("/", lambda _: FileResponse(_HERE / "templates" / "watch.html")),
            Route("/base.css", base_css),
            Route("/favicon.ico", no_icon),
            Mount("/static", StaticFiles(directory=_HERE / "static")),
            Route("/state", state),
            Route("/picture", picture),
        ],
        middleware=guards(most_bytes=0),
    )


def _state(run: WatchedRun) -> dict[str, Any]:
    tables = sorted(run.tables.glob("[0-9]*.json"), key=lambda path: int(path.stem))
    return {
        "suite": run.suite,
        "agent": run.agent,
        "done": run.count.done(),
        "total": run.total,
        "tables": [_table(path) for path in tables],
    }


def _table(path: Path) -> dict[str, Any]:
    said = LiveDocument.model_validate_json(path.read_bytes())
    return {"table": path.stem, **said.model_dump()}
