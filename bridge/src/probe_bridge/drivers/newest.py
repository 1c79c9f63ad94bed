"""The newest of what comes from a topic, and when it came."""

from __future__ import annotations

import threading
import time
from typing import Any, Tuple


class Newest:
    """Keeps the last message. `put` is a subscriber's callback, in any thread.

    Args:
        name: Of the topic, for errors.
    """

    def __init__(self, name: str) -> None:
        self._name = name
        self._news = threading.Condition()
        self._message: Any = None
        self._stamp = 0.0

    def put(self, message: Any) -> None:
        with self._news:
            self._message, self._stamp = message, time.monotonic()
            self._news.notify_all()

    def get(self) -> Tuple[Any, float]:
        """Message and time of arrival, time.monotonic().

        Raises:
            TimeoutError: None has come yet, for two seconds.
        """
        return self.after(0.0)

    def after(self, moment: float) -> Tuple[Any, float]:
        """The same, of one that came after a moment; waits for it.

        Raises:
            TimeoutError: None came for two seconds.
        """
        with self._news:
            if not self._news.wait_for(lambda: self._stamp > moment, 2.0):
                raise TimeoutError(f"nothing comes from {self._name}")
            return self._message, self._stamp
