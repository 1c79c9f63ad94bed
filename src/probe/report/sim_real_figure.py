"""The figure of simulation against reality: a point for each agent, with intervals. Geometry."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from probe.report.episodes import name_of
from probe.scores.sim_real import Compared

SIDE = 400.0
"""Of the square from 0 to 100 % both ways, in the figure's units."""

TICKS = (0.0, 0.25, 0.5, 0.75, 1.0)


@dataclass(frozen=True)
class Point:
    """One agent: across in simulation, upwards on the robot; y counts from the top.

    Attributes:
        name: Whose.
        x, y: Success.
        left, right, top, bottom: Ends of both intervals.
    """

    name: str
    x: float
    y: float
    left: float
    right: float
    top: float
    bottom: float


def points_of(agents: Iterable[Compared]) -> list[Point]:
    """Where each agent stands."""
    return [
        Point(
            name=name_of(it.entrant),
            x=place(it.sim.success),
            y=SIDE - place(it.real.success),
            left=place(it.sim.interval.low),
            right=place(it.sim.interval.high),
            top=SIDE - place(it.real.interval.high),
            bottom=SIDE - place(it.real.interval.low),
        )
        for it in agents
    ]


def place(share: float) -> float:
    """Where a share of 0 to 1 lies along a side."""
    return round(SIDE * share, 1)
