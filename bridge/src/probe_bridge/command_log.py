"""An append-only log of all that is commanded, JSON lines. Knows no robot."""

from __future__ import annotations

import json
import os
import threading
import time
from datetime import datetime, timezone
from pathlib import Path
from typing import Any, Dict, List, Optional

from probe_bridge.errors import BridgeError

NOWHERE = Path(os.devnull)
"""For a log that nobody wants."""

UNLOGGED = ("observe", "glimpse", "joints", "state", "lease")
"""Requests that command nothing."""


class CommandLog:
    """Writes a line for each event, at once, behind what the file holds already.

    Args:
        path: Where; the file is made if it isn't there.

    Raises:
        BridgeError: "fault"; it can't be written.
    """

    def __init__(self, path: Path) -> None:
        self._path = path
        self._lock = threading.Lock()
        try:
            path.parent.mkdir(parents=True, exist_ok=True)
            self._append("\n" if path.exists() and _torn(path) else "")
        except OSError as error:
            raise self._failed(error) from error

    def add(self, event: str, **about: Any) -> None:
        """Write a line: the time, by the world's clock and by time.monotonic(), and what happened.

        Raises:
            BridgeError: "fault"; it can't be written.
        """
        line = {
            "time": datetime.now(timezone.utc).isoformat(),
            "clock": round(time.monotonic(), 4),
            "event": event,
            **about,
        }
        text = json.dumps(line, separators=(",", ":"), default=repr) + "\n"
        with self._lock:
            try:
                self._append(text)
            except OSError as error:
                raise self._failed(error) from error

    def asked(self, do: str, seq: int, arguments: Dict[str, Any]) -> None:
        """Write that something was commanded; requests that command nothing leave no line."""
        if do not in UNLOGGED:
            self.add("asked", do=do, seq=seq, arguments=arguments)

    def ended(self, do: str, seq: int, error: Optional[BridgeError] = None) -> None:
        """Write what came of it."""
        if do not in UNLOGGED:
            outcome = {"outcome": "done"} if error is None else _outcome(error)
            self.add("ended", do=do, seq=seq, **outcome)

    def _append(self, text: str) -> None:
        with self._path.open("a", encoding="utf-8") as file:
            file.write(text)

    def _failed(self, error: Exception) -> BridgeError:
        return BridgeError("fault", f"The log {self._path} can't be written: {error}.")


def read_log(path: Path) -> List[Dict[str, Any]]:
    """The lines of a log; those that a dying process or a full disk has torn are left out."""
    lines: List[Dict[str, Any]] = []
    for text in path.read_text(encoding="utf-8", errors="replace").splitlines():
        try:
            line = json.loads(text)
        except ValueError:
            continue
        if isinstance(line, dict):
            lines.append(line)
    return lines


def _torn(path: Path) -> bool:
    with path.open("rb") as file:
        size = file.seek(0, os.SEEK_END)
        file.seek(max(0, size - 1))
        return file.read() not in (b"", b"\n")


def _outcome(error: BridgeError) -> Dict[str, str]:
    return {"outcome": error.kind, "text": error.text}
