"""The figure of accuracy by necessary manipulations: a curve for each entrant. Geometry only."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from probe.report.formats import surest
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
        top, bottom: Ends of its 95 % interval.
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
    """One entrant's points, the fewest manipulations first."""

    entrant: Entrant
    points: tuple[CurvePoint, ...]

    @property
    def line(self) -> str:
        """Its places, as a polyline has them."""
        return " ".join(f"{step.x},{step.y}" for step in self.points)


def curves(cards: Iterable[Scorecard]) -> list[Curve]:
    """The curve of each entrant whose tasks state what is necessary; no point lacks an episode."""
    return [Curve(card.entrant, _points(card.by_necessary)) for card in cards if card.by_necessary]


def height(share: float) -> float:
    """Where a share of 0 to 1 lies, from the top."""
    return round(HEIGHT * (1 - share), 1)


def _points(figures: tuple[Figure, ...]) -> tuple[CurvePoint, ...]:
    counts = [int(figure.name) for figure in figures]
    first, span = min(counts), max(1, max(counts) - min(counts))
    points: list[CurvePoint] = []
    for count, figure in zip(counts, figures, strict=True):
        share = figure.headline.value
        if share is None:
            continue
        interval = surest(figure)
        assert interval is not None  # there is one wherever nothing is missing
        x = round(WIDTH * (count - first) / span, 1)
        points.append(
            CurvePoint(
                count,
                figure.tasks,
                share,
                x,
                height(share),
                height(interval.high),
                height(interval.low),
            )
        )
    return tuple(points)
