"""Sends the points of a motion to a robot at a steady rate, in a thread."""

from __future__ import annotations

import threading
import time
from typing import Callable, Optional


class Stream:
    """Calls `send(seconds since the start)` every period until it says that it is done.

    Args:
        period: Seconds.
        send: Sends one point; returns whether it was the last.
    """

    def __init__(self, period: float, send: Callable[[float], bool]) -> None:
        self._period = period
        self._send = send
        self._ended = threading.Event()
        self._failed: Optional[BaseException] = None
        self._thread = threading.Thread(target=self._run, name="stream", daemon=True)
        self._thread.start()

    def done(self) -> bool:
        """Whether the last point was sent; raises what sending raised."""
        if self._failed:
            raise self._failed
        return not self._thread.is_alive()

    def stop(self) -> None:
        """Send nothing more; returns when that is certain, after a period at most."""
        self._ended.set()
        if self._thread is not threading.current_thread():
            self._thread.join()

    def _run(self) -> None:
        started = time.monotonic()
        due = started
        try:
            while not self._ended.is_set():
                if self._send(time.monotonic() - started):
                    return
                due = max(due + self._period, time.monotonic())
                self._ended.wait(due - time.monotonic())
        except Exception as error:  # whatever a robot's library raises is told by done()
            self._failed = error
