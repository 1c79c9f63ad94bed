"""The calls of a question as its page lists them, and what by their texts can be moved now."""

from __future__ import annotations

from dataclasses import dataclass

from probe.agents.reading import read_away, read_handles, read_new_handle
from probe.episodes.turns import Call, Turn
from probe.toolshed.result import MOVING, Status


@dataclass(frozen=True)
class CallEntry:
    """One call, what was told, and which picture was the newest then.

    Attributes:
        call: As it was sent.
        status: How it went.
        text: What the tool told.
        picture: Number of the newest picture, 0 being the first.
        fresh: Whether the picture came with this call.
    """

    call: Call
    status: Status
    text: str
    picture: int
    fresh: bool


def entry_of(turn: Turn, picture: int, *, fresh: bool) -> CallEntry:
    """The entry of a call that was done."""
    return CallEntry(turn.call, turn.result.status, turn.result.text, picture, fresh)


def handles_of(entries: tuple[CallEntry, ...]) -> list[dict[str, str]]:
    """What can be moved, by the tools' texts: object_ids and what the things are called.

    The latest are last, and of one reply the first. What the newest list lacks no longer shows,
    and what lies in the basket or beside it can't be reached: their ids would only be refused.
    """
    called: dict[str, str] = {}
    for entry in entries:
        if entry.call.name in ("perceive_scene", "find_object"):
            found = read_handles(entry.text)
            if entry.call.name == "perceive_scene" and entry.status == "done":
                called = {}
            # What a search was about comes first in its reply.
            for handle, thing in reversed(found.items()):
                called.pop(handle, None)
                called[handle] = thing
        elif entry.call.name in MOVING:
            _follow(called, entry)
    return [{"id": handle, "called": thing} for handle, thing in called.items()]


def _follow(called: dict[str, str], entry: CallEntry) -> None:
    """What a grasp or a push did to the thing that it was about."""
    values = entry.call.values
    moved = str(values.get("object_id")) if isinstance(values, dict) else ""
    if moved not in called:
        return
    if read_away(entry.text) == moved:
        del called[moved]
    elif (new := read_new_handle(entry.text)) is not None:
        called[new] = called.pop(moved)
