"""The page of a person who watches a robot: stop, live picture, motions that wait for a yes."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pydantic
from PIL import Image
from starlette.applications import Starlette
from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import FileResponse, JSONResponse, Response
from starlette.routing import Mount, Route
from starlette.staticfiles import StaticFiles

from probe.errors import RobotLost
from probe.files import encode
from probe.interfaces.human.guard import guards
from probe.interfaces.page_parts import base_css, no_icon
from probe.interfaces.robot.desk import ApprovalDesk
from probe.station.emergency_stop import EmergencyStop
from probe.types import Array, Frame

_HERE = Path(__file__).parent
_MOST_BYTES = 1000


@dataclass(frozen=True)
class RobotPanel:
    """What the page shows and does.

    Attributes:
        stop: A person's.
        desk: Where motions wait; None where nobody is asked.
        glance: What a camera sees now, with colours.
    """

    stop: EmergencyStop
    desk: ApprovalDesk | None
    glance: Callable[[], Frame]


class _Answer(pydantic.BaseModel, extra="forbid"):
    motion: str
    yes: bool


def app_of(panel: RobotPanel) -> Starlette:
    """The application."""
    return Starlette(
        routes=[
            Route("/", lambda _: FileResponse(_HERE / "templates" / "panel.html")),
            Route("/base.css", base_css),
            Route("/favicon.ico", no_icon),
            Mount("/static", StaticFiles(directory=_HERE / "static")),
            Route("/state", lambda _: JSONResponse(_state(panel))),
            Route("/live.jpg", _live(panel)),
            Route("/motion.jpg", _motion(panel)),
            Route("/stop", _stop(panel), methods=["POST"]),
            Route("/release", _release(panel), methods=["POST"]),
            Route("/answer", _answer(panel), methods=["POST"]),
        ],
        middleware=guards(_MOST_BYTES),
        exception_handlers={RobotLost: _lost},
    )


def _state(panel: RobotPanel) -> dict[str, Any]:
    waiting = panel.desk.waiting if panel.desk else None
    told = waiting and {
        "id": waiting.id, "number": waiting.number, "words": waiting.words
    }  # fmt: skip
    return {"stopped": panel.stop.by, "waiting": told}


def _stop(panel: RobotPanel) -> Callable[[Request], Any]:
    async def endpoint(_: Request) -> Response:
        began = time.monotonic()
        await run_in_threadpool(panel.stop.press, "the page")
        return JSONResponse({**_state(panel), "seconds": time.monotonic() - began})

    return endpoint


def _release(panel: RobotPanel) -> Callable[[Request], Any]:
    async def endpoint(_: Request) -> Response:
        panel.stop.release()
        return JSONResponse(_state(panel))

    return endpoint


def _answer(panel: RobotPanel) -> Callable[[Request], Any]:
    async def endpoint(request: Request) -> Response:
        try:
            said = _Answer.model_validate_json(await request.body())
        except pydantic.ValidationError:
            return JSONResponse({"error": "This can't be used."}, 400)
        if panel.desk is None or not panel.desk.answer(said.motion, yes=said.yes):
            return JSONResponse(
                {"error": "That motion no longer waits, or was shown only just now."}, 409
            )
        return JSONResponse(_state(panel))

    return endpoint


def _live(panel: RobotPanel) -> Callable[[Request], Response]:
    def endpoint(_: Request) -> Response:
        seen = panel.glance().rgb
        return Response(status_code=404) if seen is None else _jpeg(seen)

    return endpoint


def _motion(panel: RobotPanel) -> Callable[[Request], Response]:
    def endpoint(_: Request) -> Response:
        waiting = panel.desk.waiting if panel.desk else None
        return Response(status_code=404) if waiting is None else _jpeg(waiting.picture)

    return endpoint


def _jpeg(picture: Array) -> Response:
    return Response(encode(Image.fromarray(picture), "JPEG", quality=80), media_type="image/jpeg")


def _lost(_: Request, error: Exception) -> Response:
    return JSONResponse({"error": str(error)}, 502)
