"""What a complete answer to a question is. Knows neither the question nor the right answer."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from probe.toolshed.refusals import NoSuchOption, PointMissing, Refusal


@dataclass(frozen=True)
class AnswerForm:
    """What a complete answer to a question is.

    Attributes:
        letters: Of the options that it has.
        pointed: Those of them that need a point as well.
    """

    letters: tuple[str, ...]
    pointed: tuple[str, ...] = ()

    def lacks_point(self, choice: str, point: Sequence[float] | None) -> bool:
        """Whether an answer has no point and needs one."""
        return point is None and choice in self.pointed

    def refusal_of(
        self, choice: str, point: Sequence[float] | None, *, last: bool
    ) -> Refusal | None:
        """Why an answer isn't taken as it is; None if it is.

        Args:
            choice: Its letter.
            point: (u, v) in pixels, or None.
            last: Whether it is too late to ask for a point: that was done before, or no turn
                is left.
        """
        if choice not in self.letters:
            return NoSuchOption(choice, self.letters)
        if self.lacks_point(choice, point) and not last:
            return PointMissing()
        return None


ANY_ANSWER = AnswerForm(("A", "B", "C", "D", "E"))
"""Any letter, and never a point: how version 1 of the tools took answers."""
