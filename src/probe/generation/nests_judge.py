"""The rules that every scene with several covers keeps, whichever candidate is beneath its own."""

from __future__ import annotations

from dataclasses import dataclass, field

from probe.generation.nests import CoveredPairs
from probe.generation.removal import GhostRemoval
from probe.generation.result import Rejected
from probe.generation.twins import Twin, check_hidden
from probe.generation.visibility_rules import is_clear
from probe.tasks.truth import covered_share, lies_under


@dataclass(frozen=True, eq=False)
class NestsJudge:
    """Checks one twin after the other and keeps what it measured.

    Attributes:
        nests: The covers, and what is beneath them.
        ghosts: Take things away.
        measures: By candidate.
    """

    nests: CoveredPairs
    ghosts: GhostRemoval
    measures: dict[int, dict[str, float]] = field(default_factory=dict[int, dict[str, float]])

    def check(self, twin: Twin) -> None:
        """All rules on one scene; cheap ones first.

        What is beneath each cover is hidden; without this one and what lies on it, that alone comes
        to light.

        Raises:
            Rejected: It breaks one.
        """
        look = self.ghosts.look(twin)
        staged = self.nests.pairs_of(twin.candidate)
        pairs = [(look.number_of[item], look.number_of[cover]) for item, cover in staged]
        shapes = look.silhouettes
        seen = look.before([number for pair in pairs for number in pair])
        for hidden, cover in pairs:
            check_hidden(seen[hidden])
            if not is_clear(seen[cover]):
                raise Rejected("cover unclear", f"only {seen[cover].fraction:.0%} of one show")
            if not lies_under(shapes[hidden], shapes[cover]):
                share = covered_share(shapes[hidden], shapes[cover])
                raise Rejected("under", f"{share:.0%} within the cover's outline")
        shown = [
            look.revealed_without(look.with_what_lies_on(covering), hidden)
            for (_, covering), (hidden, _) in zip(staged, pairs, strict=True)
        ]
        (target, cover), *_ = pairs
        self.measures[twin.candidate] = {
            "hidden_share": seen[target].fraction,
            "covered_share": covered_share(shapes[target], shapes[cover]),
            **shown[0],
        }
