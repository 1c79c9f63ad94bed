"""The rules that every scene of Nested keeps, whichever candidate is at the bottom."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from probe.generation.object_selection import ObjectSelection
from probe.generation.removal import GhostRemoval
from probe.generation.result import Rejected
from probe.generation.twins import Twin, check_hidden
from probe.generation.visibility_rules import is_hidden, is_seen
from probe.question_types.nested.truth import which_nested


@dataclass(frozen=True, eq=False)
class StackJudge:
    """Checks the rules of Nested on one twin after the other and keeps what it measured.

    Attributes:
        cast: Who plays.
        ghosts: Take things away.
        measures: By candidate.
    """

    cast: ObjectSelection
    ghosts: GhostRemoval
    measures: dict[int, Mapping[str, float]] = field(default_factory=dict[int, Mapping[str, float]])

    def check(self, twin: Twin) -> None:
        """All rules on one scene; cheap ones first.

        Raises:
            Rejected: It breaks one.
        """
        look, scene = self.ghosts.look(twin), twin.scene
        target, inner, outer = (look.number_of[n] for n in (1, *self.cast.covering))
        seen = look.before([target, inner, outer])
        check_hidden(seen[target])
        if not is_hidden(seen[inner]):
            raise Rejected("inner shows", f"{seen[inner].fraction:.0%} of the inner cover show")
        if not is_seen(seen[outer]):
            raise Rejected("cover unseen", f"{seen[outer].fraction:.0%} of the cover show")
        try:
            _, between = which_nested(scene, [scene[target].object_id], outer, look.silhouettes)
        except ValueError as failure:
            raise Rejected("under", "the three don't lie beneath each other") from failure
        if between != inner:
            raise Rejected("under", "another thing lies between the two")
        below, above = self.cast.covering
        upper = look.with_what_lies_on(above)
        first = look.revealed_without(upper, inner, still=[target])
        self.measures[twin.candidate] = {
            "hidden_share": seen[target].fraction,
            **{f"inner_{name}": share for name, share in first.items()},
            **look.revealed_without([below, *upper], target),
        }
