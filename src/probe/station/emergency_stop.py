"""A person's stop: at once, from any thread, and for as long as nobody releases it."""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence

from probe.errors import StoppedByPerson


class EmergencyStop:
    """Whether a person has stopped the robot. All methods may be called from any thread.

    Args:
        halts: Bring the robot to rest, one after another.
        release: Undoes what they leave behind; nothing moves by that.
    """

    def __init__(self, halts: Sequence[Callable[[], None]], release: Callable[[], None]) -> None:
        self._halts = halts
        self._release = release
        self._lock = threading.Lock()
        self._by: str | None = None
        self._presses = 0

    @property
    def presses(self) -> int:
        """How often it has been pressed so far, releases or not."""
        return self._presses

    @property
    def by(self) -> str | None:
        """How it was pressed, in words; None if it isn't."""
        return self._by

    def press(self, by: str) -> None:
        """Stop the robot, now; pressing again stops it again.

        Args:
            by: How, in words: "the page", "a key".

        Raises:
            RobotLost: The bridge didn't confirm it. The connection is closed then, and the arm
                stops by its bridge's watchdog.
        """
        with self._lock:
            # First of all, so that nothing new begins.
            self._by = self._by or by
            self._presses += 1
        for halt in self._halts:
            halt()

    def release(self) -> None:
        """Let the robot move again; nothing moves by that."""
        self._release()
        with self._lock:
            self._by = None

    def check(self) -> None:
        """Refuse what comes while it is pressed.

        Raises:
            StoppedByPerson: It is pressed.
        """
        if self._by is not None:
            raise StoppedByPerson(f"A person stopped the robot by {self._by}.")
