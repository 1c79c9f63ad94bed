"""The figure of accuracy by necessary manipulations: a curve for each entrant. Geometry only."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from probe.scores.row import Entrant
from probe.scores.scorecard import Figure, Scorecard

WIDTH, HEIGHT = 240.0, 120.0
"""Of the plane from the fewest necessary manipulations to the most, and from 0 to 100 %."""

TICKS = (0.0, 0.5, 1.0)


@dataclass(frozen=True)
class CurvePoint:
    """Tasks that take equally many manipulations.

    Attributes:
        necessary: How many.
        tasks: How many tasks.
        share: Of them that are right.
        x, y: Where that lies; y counts from the top.
        top, bottom: Ends of its 95 % interval; where y is without one.
    """

    necessary: int
    tasks: int
    share: float
    x: float
    y: float
    top: float
    bottom: float


@dataclass(frozen=True)
class Curve:
    """One entrant's steps, the fewest manipulations first."""

    entrant: Entrant
    steps: tuple[CurvePoint, ...]

    @property
    def line(self) -> str:
        """Its points, as a polyline has them."""
        return " ".join(f"{step.x},{step.y}" for step in self.steps)


def curves(cards: Iterable[Scorecard]) -> list[Curve]:
    """The curve of each entrant whose tasks state what is necessary, without steps with gaps."""
    return [Curve(card.entrant, _steps(card.by_necessary)) for card in cards if card.by_necessary]


def height(share: float) -> float:
    """Where a share of 0 to 1 lies, from the top."""
    return round(HEIGHT * (1 - share), 1)


def _steps(figures: tuple[Figure, ...]) -> tuple[CurvePoint, ...]:
    counts = [int(figure.name) for figure in figures]
    first, span = min(counts), max(1, max(counts) - min(counts))
    steps: list[CurvePoint] = []
    for count, figure in zip(counts, figures, strict=True):
        share = figure.headline.value
        if share is None:
            continue
        interval = figure.wilson or figure.student
        low, high = (share, share) if interval is None else (interval.low, interval.high)
        x = round(WIDTH * (count - first) / span, 1)
        steps.append(
            CurvePoint(count, figure.tasks, share, x, height(share), height(high), height(low))
        )
    return tuple(steps)
