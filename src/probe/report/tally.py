"""Results to rates: by question type, with n and an interval."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from scipy.stats import binomtest

from probe.report.episode_view import EpisodeView


@dataclass(frozen=True)
class Rate:
    """Right answers of n, with a 95 % Wilson interval (Wilson, JASA 22(158), 1927).

    Attributes:
        name: Of the row: a question type, or "all".
        chance: Mean chance of a blind guess among the options.
        faults: Episodes that our own failure ended; in n, never counted as right.
    """

    name: str
    right: int
    n: int
    low: float
    high: float
    chance: float
    faults: int

    @property
    def share(self) -> float:
        """Right answers over n."""
        return self.right / self.n


def rates(views: Sequence[EpisodeView]) -> list[Rate]:
    """A row for each question type, in order of name, and one for all of them together."""
    kinds = sorted({view.kind for view in views})
    rows = [_rate(kind, [view for view in views if view.kind == kind]) for kind in kinds]
    return [*rows, _rate("all", views)]


def _rate(name: str, views: Sequence[EpisodeView]) -> Rate:
    right = sum(view.score.correct for view in views)
    interval = binomtest(right, len(views)).proportion_ci(method="wilson")
    return Rate(
        name=name,
        right=right,
        n=len(views),
        low=float(interval.low),
        high=float(interval.high),
        chance=sum(1 / len(view.record.question.options) for view in views) / len(views),
        faults=sum(view.record.end == "fault" for view in views),
    )
