"""The rules that a scene of Ranked keeps, whichever candidate has the rank that is asked for."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from probe.generation.nests_judge import NestsJudge
from probe.generation.result import Rejected
from probe.generation.shown import LEVEL, SHOWN_LONGER, height_spread, least_step
from probe.generation.twins import Twin


@dataclass(frozen=True, eq=False)
class RankedJudge:
    """Checks one twin after the other.

    Attributes:
        base: The rules of covers side by side; keeps what was measured.
        lengths: Longest sides in metres, by instance on the stage.
    """

    base: NestsJudge
    lengths: Mapping[int, float]

    def check(self, twin: Twin) -> None:
        """All rules on one scene: the covers are level, and what they hide looks as long as it is.

        Raises:
            Rejected: It breaks one.
        """
        self.base.check(twin)
        look = self.base.ghosts.look(twin)
        pairs = self.base.nests.pairs_of(twin.candidate)
        covers = [look.number_of[cover] for _, cover in pairs]
        if (spread := height_spread(look.silhouettes, covers)) > LEVEL:
            raise Rejected("level", f"one cover stands {1000 * spread:.0f} mm higher than another")
        order = sorted((item for item, _ in pairs), key=lambda it: self.lengths[it], reverse=True)
        numbers = [look.number_of[item] for item in order]
        step = 0.0
        gone = {number for _, cover in pairs for number in look.with_what_lies_on(cover)}
        for how, after in look.removals(gone):
            step = least_step(after.labels, numbers)
            if step < SHOWN_LONGER:
                raise Rejected(f"order {how}", f"one thing looks {step:.2f} times as long")
        self.base.measures[twin.candidate] |= {"height_spread": spread, "least_step": step}
