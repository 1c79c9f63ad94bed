"""What an attempt to make a task comes to, and counts of that. Data only."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from probe.errors import ProbeError
from probe.scene.scene import Scene
from probe.tasks.task import Task


@dataclass(frozen=True)
class Candidate:
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


@dataclass(frozen=True)
class Yield:
    """Counts of attempts; printed by whoever runs them.

    Attributes:
        kept: Those that became tasks.
        rejected: Those that failed, by check.
    """

    kept: int
    rejected: Mapping[str, int]

    @staticmethod
    def of(results: Iterable[Candidate | Rejection]) -> Yield:
        """Count the results of many attempts."""
        counts = Counter("" if isinstance(r, Candidate) else r.check for r in results)
        kept = counts.pop("", 0)
        return Yield(kept, dict(counts.most_common()))

    @property
    def attempts(self) -> int:
        """All attempts."""
        return self.kept + sum(self.rejected.values())

    @property
    def share(self) -> float:
        """Share of attempts that were kept, 0 to 1."""
        return self.kept / self.attempts if self.attempts else 0.0
