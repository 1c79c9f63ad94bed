"""What there is to do, as every engine takes it: units that don't depend on each other. Data only.

Which units are left and which of them belong to a shard is decided before a plan is made. A unit
has a key, so that its result has a place of its own whoever does it.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
from dataclasses import dataclass
from typing import Generic, Protocol, TypeVar

from probe.processes.serving import Opening

Unit = TypeVar("Unit")

TRIES = 3
"""How often a unit is begun when workers die over it."""


@dataclass(frozen=True)
class WorkPlan(Generic[Unit]):
    """Units of work, and what does one.

    Attributes:
        name: What all units have in common, such as a suite's hash and an agent, as a digest or
            in letters, digits and hyphens.
        opening: Sets up what does a unit; its result depends on the unit alone.
        units: In the order in which they are begun.
        key: Names a unit within the plan, in letters, digits, dots and hyphens.
    """

    name: str
    opening: Opening[Unit, bytes]
    units: Sequence[Unit]
    key: Callable[[Unit], str]


@dataclass(frozen=True)
class LostUnit:
    """What is left of a unit over which every worker died.

    Attributes:
        reason: In words.
    """

    reason: str


class Engine(Protocol):
    """Does the units of a plan somewhere."""

    def carry_out(self, plan: WorkPlan[Unit]) -> Generator[tuple[Unit, bytes | LostUnit]]:
        """Do all units; yields each with what came of it, as it is known, each once.

        What was yielded counts as kept by whoever takes it when the next is asked for. Close the
        iterator to end all workers at once.

        Raises:
            WorkerUnfit: No worker could be set up.
            WorkerDied: Workers keep dying before they get anything to do.
        """
        ...
