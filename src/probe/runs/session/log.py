"""A session's log: lines are added at its end, and each names the one before."""

from __future__ import annotations

import hashlib
from datetime import UTC, datetime
from pathlib import Path

import pydantic

from probe.checksum import with_sum, without_sum
from probe.episodes.files import append_line, lines_of, set_aside_cut
from probe.errors import BadData
from probe.files import fault
from probe.runs.session.events import Begun, Entry, Event

LOG = "session.jsonl"


class SessionLog:
    """Reads what was logged, and adds to it.

    Args:
        out: Folder of the session.

    Raises:
        BadData: A line was changed, or one was left out.
        OutputFailed: A last line that was cut off can't be moved aside.
    """

    def __init__(self, out: Path) -> None:
        self._path = out / LOG
        self.cut = set_aside_cut(self._path)
        """Where a last line that was cut off has been put; None if none was."""
        self.events, self._last = _read(self._path) if self._path.exists() else ([], "")

    def add(self, event: Event) -> None:
        """Write an event at the end, and have it on the disk when this returns.

        Raises:
            OutputFailed: It can't be written; nothing of it is left.
        """
        now = datetime.now(UTC).isoformat(timespec="seconds")
        entry = Entry(at=now, before=self._last, event=event)
        line = with_sum(entry.model_dump_json(exclude_none=True).encode())
        append_line(self._path, line)
        self.events.append(event)
        self._last = hashlib.sha256(line).hexdigest()


def read_log(out: Path) -> list[Event]:
    """All events of a session; a last line that was cut off is left out.

    Raises:
        BadData: There is no log, a line was changed, or one was left out.
    """
    events, _ = _read(out / LOG)
    return events


def begun_in(events: list[Event], out: Path) -> Begun:
    """The event that a log starts with.

    Raises:
        BadData: It starts with another.
    """
    if not events or not isinstance(events[0], Begun):
        raise BadData(out / LOG, "doesn't start with a session", "Start it anew elsewhere")
    return events[0]


def _read(path: Path) -> tuple[list[Event], str]:
    events, before = list[Event](), ""
    for number, line in enumerate(lines_of(path, whole=False), start=1):
        place, remedy = f"{path}, line {number}", "This log proves nothing any more"
        try:
            entry = Entry.model_validate_json(without_sum(line))
        except pydantic.ValidationError as error:
            raise BadData(place, fault(error, "the line"), remedy) from error
        except ValueError as error:
            raise BadData(place, str(error), remedy) from error
        if entry.before != before:
            raise BadData(place, "doesn't follow the line before it", remedy)
        events.append(entry.event)
        before = hashlib.sha256(line + b"\n").hexdigest()
    return events, before
