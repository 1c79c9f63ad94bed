"""By how much a timed motion passes limits between its samples."""

from __future__ import annotations

import math
from typing import Sequence

from probe_bridge.config import Config
from probe_bridge.fields import Vector
from probe_bridge.geometry import distance
from probe_bridge.trajectory import Trajectory


def joints_excess(motion: Trajectory, config: Config) -> float:
    """By what the time must be multiplied so that no joint is beyond a limit between samples.

    A piece of the motion is a cubic: its acceleration is largest at an end, its speed there or
    where the acceleration is zero.
    """
    most = 0.0
    for i in range(len(motion.times) - 1):
        h = motion.times[i + 1] - motion.times[i]
        rows = (motion.joints, motion.velocities)
        for joint, a, b, m, n in zip(
            config.chain.joints, *(r[k] for r in rows for k in (i, i + 1))
        ):
            d = (b - a) / h
            first, last = (6 * d - 4 * m - 2 * n) / h, (2 * m + 4 * n - 6 * d) / h
            speed = max(abs(m), abs(n))
            if first * last < 0.0:
                speed = max(speed, abs(m + first * first * h / (2 * (first - last))))
            bend = max(abs(first), abs(last)) / joint.acceleration
            most = max(most, speed / joint.speed, math.sqrt(bend))
    return most


def points_excess(motion: Trajectory, points: Sequence[Sequence[Vector]], config: Config) -> float:
    """The same for the speeds of the watched points, measured over half pieces.

    Args:
        motion: What is measured.
        points: The watched points at its times, metres.
        config: Whose limits count.
    """
    most = 0.0
    for i in range(len(motion.times) - 1):
        half = (motion.times[i + 1] - motion.times[i]) / 2
        middle = config.chain.watched(motion.at(motion.times[i] + half)[0])
        for before, between, after in zip(points[i], middle, points[i + 1]):
            most = max(most, distance(before, between) / half, distance(between, after) / half)
    return most / config.tool_speed
