"""What an episode is planned to be like, and what such plans turn through. Data only."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import Generic, TypeVar

from probe.scene.setup import UR5_TABLE, Setup
from probe.tasks.task import LETTERS, NEWEST_RULES, PAIR, Letter, RulesVersion
from probe.tasks.type_rules import Form

_T = TypeVar("_T")


@dataclass(frozen=True)
class TaskPlan:
    """What all attempts of an episode share.

    Attributes:
        letter: The right answer's; E means that the true candidate is the one left out.
        wording: Which of the type's wordings asks.
        form: That wording's.
        places: Of each property that the type is planned by, by its purpose, which of its values it
            takes; see PlannedProperty.of().
        setup: The table it is for.
        rules: The version of the rules that it is made by.
    """

    letter: Letter
    wording: int
    form: Form
    places: Mapping[str, int]
    setup: Setup = UR5_TABLE
    rules: RulesVersion = NEWEST_RULES


@dataclass(frozen=True)
class PlannedProperty(Generic[_T]):
    """A property that takes each of its values equally often in every block of episodes.

    Attributes:
        purpose: Its name, from which its order is drawn.
        values: As often as they stand here.
    """

    purpose: str
    values: Sequence[_T]

    def of(self, plan: TaskPlan) -> _T:
        """The value in a plan."""
        return self.values[plan.places[self.purpose]]

    def put(self, plan: TaskPlan, value: _T) -> TaskPlan:
        """The plan with another value."""
        return replace(plan, places={**plan.places, self.purpose: self.values.index(value)})


LETTER = PlannedProperty[Letter]("letter", LETTERS)
"""The right letter, of types with five options."""

CROSSED = PlannedProperty("crossed", tuple(product(PAIR, (True, False), (True, False))))
"""Of types about two marked things: the right letter and two cues of what shows."""

MORE_CUES = PlannedProperty("cues", tuple(product((True, False), repeat=2)))
"""Of types about two marked things: two more cues."""
