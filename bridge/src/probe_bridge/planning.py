"""From a path that a client wants to a motion that keeps every limit, or a reason why not."""

from __future__ import annotations

from typing import List, Sequence

from probe_bridge.config import Config
from probe_bridge.curve import Row, Sample, sampled
from probe_bridge.errors import BridgeError
from probe_bridge.fields import Vector
from probe_bridge.timing import timed
from probe_bridge.trajectory import Trajectory

START = 0.05
"""Radians by which a path's first waypoint may differ from where the arm is."""

TRAVEL = 40.0
"""Longest path, radians of the joint that moves most."""

_STEP = 0.005
"""Radians between the samples that are checked, of the joint that moves most, on average over a
piece of the curve; it is at most three times as steep. Between two samples inside a box, a point of
an arm of 1 m strays from their chord by 1 mm at most, even if six joints turn at once."""

_SAME = 1e-6
_START_OUT = 0.005
"""Metres by which a point may be outside where the arm stands: its encoders are not exact."""


def plan(path: Sequence[Row], measured: Row, config: Config) -> Trajectory:
    """The motion through a path, checked as a whole.

    Args:
        path: Waypoints, radians; the first is where the arm is, within START.
        measured: Where the arm is.
        config: Whose limits count.

    Raises:
        BridgeError: "refused", with the waypoint and the limit.
    """
    _check_waypoints(path, measured, config)
    kept = _distinct([measured, *path])
    if len(kept) == 1:
        return Trajectory((0.0,), (measured,), ((0.0,) * len(measured),))
    travel = sum(max(abs(b - a) for a, b in zip(p, q)) for p, q in zip(kept, kept[1:]))
    if travel > TRAVEL:
        raise BridgeError("refused", f"The path is {travel:.0f} rad long; {TRAVEL:.0f} at most.")
    samples = sampled(kept, _STEP)
    points = [config.chain.watched(sample.joints) for sample in samples]
    _check_boxes(samples, points, config)
    return timed(samples, points, config)


def _check_waypoints(path: Sequence[Row], measured: Row, config: Config) -> None:
    for number, row in enumerate(path):
        for angle, joint in zip(row, config.chain.joints):
            if not joint.lower <= angle <= joint.upper:
                raise BridgeError(
                    "refused",
                    f"Waypoint {number} turns {joint.name} to {angle:.3f} rad, outside"
                    f" {joint.lower:.3f} to {joint.upper:.3f}.",
                )
    away = [abs(a - b) for a, b in zip(path[0], measured)]
    if max(away) > START:
        joint = config.chain.joints[away.index(max(away))].name
        raise BridgeError(
            "refused",
            f"The path begins {max(away):.3f} rad from where {joint} is.",
            "Begin it with the measured joint angles.",
        )


def _distinct(path: Sequence[Row]) -> List[Row]:
    """The path without waypoints that repeat the one before; its end stays exact."""
    kept = [path[0]]
    for row in path[1:]:
        if max(abs(a - b) for a, b in zip(row, kept[-1])) > _SAME:
            kept.append(row)
        elif len(kept) > 1:
            kept[-1] = row
    return kept


def _check_boxes(
    samples: Sequence[Sample], points: Sequence[Sequence[Vector]], config: Config
) -> None:
    for sample, watched in zip(samples, points):
        slack = _START_OUT if sample.along <= START else 0.0
        stray = stray_point(watched, config, slack)
        if stray:
            raise BridgeError("refused", f"{sample.along:.2f} rad along the path, {stray}.")


def stray_point(points: Sequence[Vector], config: Config, slack: float) -> str:
    """Which watched point is outside its box by more than a slack in metres; "" if none is."""
    for number, point in enumerate(points):
        box = config.arm_box if number else config.tool_box
        if box.outside(point) > slack:
            name = f"the arm's point {number - 1}" if number else "the tool"
            at = ", ".join(f"{v:.3f}" for v in point)
            return f"{name} is at ({at}), outside its box"
    return ""
