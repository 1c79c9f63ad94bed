"""A person whose name looks like a path: a name like any other, while every file stays inside."""

from __future__ import annotations

import json
import time
import urllib.request
from pathlib import Path
from typing import Any
from urllib.parse import urlencode

from command import PATIENCE, probe
from verdict import Attack

from probe.episodes.files import read_records
from probe.episodes.folder import RECORDS

NAME = "../.."
_LOOK = {"tool": "find_object", "arguments": {"description": "the thing at (500, 500)"}}


def plays(port: int) -> None:
    """Take a seat under that name, call a tool, end the question.

    Raises:
        OSError: The page refuses one of these, or takes too long.
    """
    _post(port, "enter")
    _post(port, "call", turn=_turn(port), **_LOOK)
    _post(port, "stop", turn=_turn(port))
    _turn(port)


def judged(kind: str, home: Path, folder: Path, before: set[Path]) -> Attack:
    """What became of the name, once the server has ended: in a record, a report, in no path.

    Args:
        kind: What is attacked.
        home: A folder in which nothing but the server's own may have changed.
        folder: The server's.
        before: What was in `home` before.
    """
    name = f"a person called {NAME}"
    reported = probe("report", folder)
    if reported.returncode != 0:
        return Attack(kind, name, "crashed", reported.stderr[-300:])
    new = {path for path in home.rglob("*") if folder not in (path, *path.parents)} - before
    kept = [record.agent for record in read_records(folder / RECORDS)] == [NAME]
    if new or not kept:
        return Attack(kind, name, "read wrongly", f"new outside: {new}; kept as told: {kept}")
    return Attack(kind, name, "harmless")


def _post(port: int, what: str, **fields: object) -> None:
    request = urllib.request.Request(
        f"http://127.0.0.1:{port}/seat/{what}",
        json.dumps({"name": NAME, **fields}).encode(),
        {"Content-Type": "application/json"},
    )
    with urllib.request.urlopen(request, timeout=PATIENCE):
        pass


def _turn(port: int) -> int:
    """How many calls there have been, once nothing is going on any more."""
    address = f"http://127.0.0.1:{port}/seat/state?{urlencode({'name': NAME})}"
    since = time.monotonic()
    while time.monotonic() - since < PATIENCE:
        with urllib.request.urlopen(address, timeout=PATIENCE) as reply:
            state: dict[str, Any] = json.load(reply)
        if state["doing"] is None:
            return len(state["entries"])
        time.sleep(0.3)
    raise TimeoutError(f"something is still going on after {PATIENCE:.0f} s")
