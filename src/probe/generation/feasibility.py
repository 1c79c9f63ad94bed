"""Which types of tasks a library has the things for, before anything is built. No physics.

It asks the generators themselves who would play; what then lies, tips or shows is not looked at.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from probe.assets.library import Library
from probe.generation.attempt import Attempt
from probe.generation.build_folder import TaskSlot
from probe.generation.generate import SELECTORS
from probe.generation.needs import NEEDS
from probe.generation.result import Rejected
from probe.generation.salt import Salt
from probe.scene.seeds import generator
from probe.tasks.task import KINDS, QuestionKind

TRIES = 40
"""Castings of a place that must all fail before it is called impossible."""


@dataclass(frozen=True)
class Feasibility:
    """Whether there are the things for a type.

    Attributes:
        kind: The type.
        places: Those asked for.
        hopeless: Those for which nobody could be cast.
        missing: Why, for people: what the castings failed by, the most frequent first.
    """

    kind: QuestionKind
    places: tuple[TaskSlot, ...]
    hopeless: tuple[TaskSlot, ...]
    missing: tuple[str, ...]

    @property
    def needs(self) -> str:
        """What the type takes."""
        return NEEDS[self.kind]


def possibilities(
    places: Sequence[TaskSlot], library: Library, salt: Salt | None = None
) -> tuple[Feasibility, ...]:
    """What can be made of a library, type by type.

    Args:
        places: The tasks that are asked for.
        library: The things.
        salt: Of a private suite.
    """
    kinds: list[QuestionKind] = [
        kind for kind in KINDS if any(place.kind == kind for place in places)
    ]
    return tuple(
        _of_kind(kind, tuple(p for p in places if p.kind == kind), library, salt) for kind in kinds
    )


def _of_kind(
    kind: QuestionKind, places: tuple[TaskSlot, ...], library: Library, salt: Salt | None
) -> Feasibility:
    failures = Counter[str]()
    hopeless = tuple(
        place for place in places if not _can_be_selected(place, library, salt, failures)
    )
    return Feasibility(
        kind, places, hopeless, tuple(reason for reason, _ in failures.most_common())
    )


def _can_be_selected(
    place: TaskSlot, library: Library, salt: Salt | None, failures: Counter[str]
) -> bool:
    """Whether anybody can play; what went wrong is counted if nobody can."""
    mine = Counter[str]()
    for number in range(TRIES):
        attempt = Attempt(place, number, salt)
        rng = generator(attempt.seed, place.kind, "possible")
        try:
            SELECTORS[place.kind](library, attempt.plan, rng)
        except Rejected as failure:
            mine[str(failure)] += 1
        else:
            return True
    failures.update(mine)
    return False
