"""How late threads are on this machine just now."""

from __future__ import annotations

import threading
import time


class Machine:
    """How late this machine itself is, as it may be busy with other things."""

    def __init__(self) -> None:
        self._worst = 0.0
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._look)
        self._thread.start()

    @property
    def late(self) -> float:
        """Seconds by which what several threads do in turn may be late here and now."""
        return 0.1 + 4 * self._worst

    def close(self) -> None:
        self._ended.set()
        self._thread.join()

    def _look(self) -> None:
        while not self._ended.is_set():
            before = time.monotonic()
            time.sleep(0.005)
            self._worst = max(self._worst, time.monotonic() - before - 0.005)
