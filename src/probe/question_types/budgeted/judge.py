"""The rules that a scene of Budgeted keeps, whichever candidate is there."""

from __future__ import annotations

from dataclasses import dataclass

from probe.generation.nests_judge import NestsJudge
from probe.generation.object_selection import ObjectSelection
from probe.generation.result import Rejected
from probe.generation.shown import SHOWN_LONGER, least_step
from probe.generation.twins import Twin

LIFTED = 0.003
"""Metres by which a cover may stand higher than on a bare table: what is beneath mustn't tell."""


@dataclass(frozen=True, eq=False)
class BudgetedJudge:
    """Checks one twin after the other.

    Attributes:
        base: The rules of covers side by side; keeps what was measured.
        cast: Who plays.
    """

    base: NestsJudge
    cast: ObjectSelection

    def check(self, twin: Twin) -> None:
        """All rules on one scene; covers stand on the table, and what is long looks long.

        Raises:
            Rejected: It breaks one.
        """
        self.base.check(twin)
        numbers = [self.base.ghosts.frame.number_of[it] for it in self.cast.covering]
        shapes = self.base.ghosts.view.silhouettes(twin.scene, numbers)
        rises = [
            shapes[number].top - cover.extent[2]
            for number, cover in zip(numbers, self.cast.covers, strict=True)
        ]
        if max(rises) > LIFTED:
            raise Rejected("stands", f"a cover stands {1000 * max(rises):.0f} mm off the table")
        step = self._least_step(twin)
        self.base.measures[twin.candidate] |= {"highest_rise": max(rises), "least_step": step}

    def _least_step(self, twin: Twin) -> float:
        """How many times as long the candidate looks as anything else beneath a cover.

        Raises:
            Rejected: Too few.
        """
        look, pairs = self.base.ghosts.look(twin), self.base.nests.pairs_of(twin.candidate)
        target, *others = (look.number_of[item] for item, _ in pairs)
        step = 0.0
        for how, after in look.removals([cover for _, cover in pairs]):
            step = min(least_step(after.labels, (target, other)) for other in others)
            if step < SHOWN_LONGER:
                raise Rejected(f"order {how}", f"it looks {step:.2f} times as long as another")
        return step
