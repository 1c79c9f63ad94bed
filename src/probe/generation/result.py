"""What an attempt to make a task comes to. Data only."""

from __future__ import annotations

from dataclasses import dataclass

from probe.errors import ProbeError
from probe.scene.scene import Scene
from probe.tasks.task import Task


@dataclass(frozen=True)
class TaskCandidate:
    """A task that passed all checks on its scene.

    Attributes:
        task: The task.
        twins: The scene with each of the certificate's candidates in the true one's place, in
            their order; empty where the type needs none.
    """

    task: Task
    twins: tuple[Scene, ...] = ()


@dataclass(frozen=True)
class Rejection:
    """An attempt that came to nothing.

    Attributes:
        check: Which check it failed; a few fixed names.
        detail: What was measured, for people.
    """

    check: str
    detail: str


class Rejected(ProbeError):
    """Ends an attempt; generate() turns it into a Rejection."""

    def __init__(self, check: str, detail: str) -> None:
        super().__init__(f"{check}: {detail}")
        self.rejection = Rejection(check, detail)
