"""Where a planned motion waits until a person says yes or no, by whatever way comes first."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from pathlib import Path

from PIL import Image

from probe.files import encode, write_bytes
from probe.station.approved import Over, PlannedMotion

MOTIONS = "motions"
"""Folder beside a run's records, for the pictures of the motions that were asked for."""


QUICKEST = 0.3
"""Seconds before which nobody has looked at a picture: a key that was pressed twice answers the
first motion alone."""


class ApprovalDesk:
    """Keeps what a motion's picture shows, and waits. Any thread may answer.

    Args:
        folder: Of the run.
        tell: Is told of each motion that begins to wait, and of the file of its picture.
        note: Is told of each answer.
    """

    def __init__(
        self,
        folder: Path,
        tell: Callable[[PlannedMotion, Path], None],
        note: Callable[[PlannedMotion, bool], None],
    ) -> None:
        self._folder = folder / MOTIONS
        self._tell = tell
        self._note = note
        self._before = len(list(self._folder.glob("*.jpg")))
        self._answered = threading.Condition()
        self._waiting: PlannedMotion | None = None
        self._answer: bool | None = None
        self._since = 0.0

    @property
    def waiting(self) -> PlannedMotion | None:
        """The motion that waits for an answer."""
        return self._waiting if self._answer is None else None

    def ask(self, motion: PlannedMotion, over: Over) -> bool:
        """Wait for a person's answer, for as long as it takes; no, where the episode is over.

        Raises:
            OutputFailed: The picture can't be written.
        """
        path = self._folder / f"{self._before + motion.number:04d}.jpg"
        write_bytes(path, encode(Image.fromarray(motion.picture), "JPEG", quality=90))
        with self._answered:
            self._tell(motion, path)
            self._answer, self._waiting, self._since = None, motion, time.monotonic()
            while self._answer is None and not over():
                # In slices, so that Ctrl-C gets through.
                self._answered.wait(0.5)
            answer, self._waiting = bool(self._answer), None
        self._note(motion, answer)
        return answer

    def answer(self, motion: str, *, yes: bool) -> bool:
        """Answer the motion of that id; whether that counts.

        It doesn't if that motion waits no more, and a yes that comes too soon doesn't either.
        """
        with self._answered:
            if self._waiting is None or self._waiting.id != motion or self._answer is not None:
                return False
            if yes and time.monotonic() - self._since < QUICKEST:
                return False
            self._answer = yes
            self._answered.notify_all()
            return True

    def refuse(self) -> None:
        """Say no to whatever waits."""
        waiting = self._waiting
        if waiting is not None:
            self.answer(waiting.id, yes=False)
