"""What pages ask for, over HTTP."""

from __future__ import annotations

import logging
from collections.abc import Callable, Mapping
from typing import Annotated, Any, TypeVar

import pydantic
from starlette.applications import Starlette
from starlette.concurrency import run_in_threadpool
from starlette.requests import Request
from starlette.responses import JSONResponse, Response
from starlette.routing import Route

from probe.episodes.remarks import LONGEST
from probe.episodes.turns import Call
from probe.errors import ProbeError
from probe.files import fault
from probe.interfaces.human.guard import guards
from probe.interfaces.human.names import BadName
from probe.interfaces.human.pages import page_routes
from probe.interfaces.human.session import HumanSession
from probe.interfaces.human.session_manager import SessionManager
from probe.interfaces.human.state import as_json
from probe.interfaces.human.words import NotNow

_log = logging.getLogger(__name__)

_MOST_BYTES = 20_000
"""Of a request; a find_object with the longest words has some 2,000."""


class _Named(pydantic.BaseModel, extra="forbid"):
    """Who asks, and whether to practise."""

    name: Annotated[str, pydantic.Field(max_length=200)]
    practice: bool = False


class _Calling(_Named):
    """A call of a tool, and how many calls the person has seen the outcome of."""

    turn: int
    tool: Annotated[str, pydantic.Field(max_length=40)]
    arguments: dict[str, Any]


class _Stopping(_Named):
    """The end without an answer."""

    turn: int


class _Remarking(_Named):
    """What is said of the question of that number."""

    number: int
    ambiguous: bool
    note: Annotated[str, pydantic.Field(max_length=LONGEST)]


class BadRequest(ProbeError):
    """A request that no page of ours makes."""


Asked = TypeVar("Asked", bound=_Named)


def app_of(sessions: SessionManager) -> Starlette:
    """The application; it leaves the hall open."""
    acts = [
        _act("enter", _Named, lambda it: sessions.enter(it.name, practice=it.practice)),
        _act("next", _Named, _seated(sessions, _go_on)),
        _act("call", _Calling, _seated(sessions, _call)),
        _act("stop", _Stopping, _seated(sessions, _stop)),
        _act("remark", _Remarking, _seated(sessions, _remark)),
    ]
    return Starlette(
        routes=[*page_routes(sessions.scale, sessions.practice), *acts, *_sights(sessions)],
        middleware=guards(_MOST_BYTES),
        exception_handlers={ProbeError: _told, Exception: _failed},
    )


def _go_on(seat: HumanSession, _: _Named) -> None:
    seat.go_on()


def _stop(seat: HumanSession, it: _Stopping) -> None:
    seat.stop(it.turn)


def _call(seat: HumanSession, it: _Calling) -> None:
    seat.call(Call.of(it.tool, it.arguments), it.turn)


def _remark(seat: HumanSession, it: _Remarking) -> None:
    seat.remark(it.number, ambiguous=it.ambiguous, note=it.note.strip())


def _seated(
    sessions: SessionManager, act: Callable[[HumanSession, Asked], None]
) -> Callable[[Asked], HumanSession]:
    """To do something at the seat of whoever asks."""

    def at_seat(asked: Asked) -> HumanSession:
        seat = _seat(sessions, asked.name, practice=asked.practice)
        act(seat, asked)
        return seat

    return at_seat


def _seat(sessions: SessionManager, name: str, *, practice: bool) -> HumanSession:
    seat = sessions.seat(name, practice=practice)
    if seat is None:
        raise NotNow("You have no seat any more. Load the page again to get one.")
    return seat


def _act(path: str, kind: type[Asked], act: Callable[[Asked], HumanSession]) -> Route:
    """A route that does something and replies with the state that follows."""

    async def endpoint(request: Request) -> Response:
        try:
            asked = kind.model_validate_json(await request.body())
        except pydantic.ValidationError as error:
            raise BadRequest(f"This can't be used: {fault(error, 'the request')}.") from error
        seat = await run_in_threadpool(act, asked)
        return JSONResponse(as_json(seat.state))

    return Route(f"/seat/{path}", endpoint, methods=["POST"])


def _sights(sessions: SessionManager) -> list[Route]:
    """What can be looked at without changing anything."""

    def seat_of(request: Request) -> HumanSession:
        said = request.query_params
        return _seat(sessions, _said(said, "name"), practice=said.get("practice") == "1")

    def state(request: Request) -> Response:
        return JSONResponse(as_json(seat_of(request).state))

    def shown(find: Callable[[HumanSession, int], bytes | None]) -> Callable[[Request], Response]:
        def picture(request: Request) -> Response:
            seat, number = seat_of(request), _said(request.query_params, "number")
            found = find(seat, int(number)) if number.isdecimal() and len(number) < 4 else None
            if found is None:
                raise BadRequest("There is no such picture.")
            return Response(found, media_type="image/png")

        return picture

    return [
        Route("/seat/state", state),
        Route("/seat/picture", shown(lambda seat, number: seat.picture(number))),
        Route("/seat/evidence", shown(lambda seat, number: seat.evidence(number))),
    ]


def _said(parameters: Mapping[str, str], name: str) -> str:
    if name not in parameters:
        raise BadRequest(f"The address lacks {name!r}.")
    return parameters[name]


def _told(request: Request, error: Exception) -> Response:
    """What a person may know of an error of theirs; other errors are ours."""
    if isinstance(error, NotNow | BadName | BadRequest):
        return JSONResponse({"error": str(error)}, 409 if isinstance(error, NotNow) else 400)
    _log.error("%s", error)
    return _failed(request, error)


def _failed(_: Request, __: Exception) -> Response:
    said = "Something failed that is not your doing; the server's log says what."
    return JSONResponse({"error": said}, 500)
