"""Measures a motion against a robot's file, by other sums than the bridge's."""

from __future__ import annotations

import math
from typing import Any, Dict, List, Sequence, Tuple

from probe_bridge.trajectory import Trajectory
from ur5_figures import points

_TINY = 1e-6
_ARC = 3e-4
"""Metres by which a point may stray between two samples that are inside."""

State = Tuple[Tuple[float, ...], Tuple[float, ...]]


def broken_limits(
    motion: Trajectory, seconds: float, raw: Dict[str, Any], samples: int
) -> List[str]:
    """Which limits the first seconds of a practice arm's motion break; empty if none.

    Speeds are differences of positions between neighbouring samples.
    """
    step = max(seconds / samples, 1e-9)
    states = [motion.at(step * i) for i in range(samples + 1)]
    return [*_joints_wrong(states, step, raw), *_points_wrong(states, step, raw)]


def _joints_wrong(states: Sequence[State], step: float, raw: Dict[str, Any]) -> List[str]:
    wrong: List[str] = []
    for number, joint in enumerate(raw["joints"]):
        angles = [angles[number] for angles, _ in states]
        speeds = [speeds[number] for _, speeds in states]
        if min(angles) < joint["lower"] - _TINY or max(angles) > joint["upper"] + _TINY:
            wrong.append(f"{joint['name']} leaves its range")
        if _steepest(angles) / step > joint["speed"]:
            wrong.append(f"{joint['name']} is too fast")
        if _steepest(speeds) / step > joint["acceleration"]:
            wrong.append(f"{joint['name']} accelerates too much")
    return wrong


def _steepest(values: Sequence[float]) -> float:
    return max(abs(b - a) for a, b in zip(values, values[1:]))


def _points_wrong(states: Sequence[State], step: float, raw: Dict[str, Any]) -> List[str]:
    wrong: List[str] = []
    places = [points(angles) for angles, _ in states]
    for number, name in enumerate(("flange", "pads", "elbow", "wrist")):
        box = raw["arm_box"] if number else raw["tool_box"]
        track = [place[number] for place in places]
        if max(math.dist(a, b) for a, b in zip(track, track[1:])) / step > raw["tool_speed"]:
            wrong.append(f"the {name} is too fast")
        for axis in range(3):
            values = [point[axis] for point in track]
            if min(values) < box["lower"][axis] - _ARC or max(values) > box["upper"][axis] + _ARC:
                wrong.append(f"the {name} leaves its box")
    return wrong
