"""Which places of the work area the hand gets to from above, by the arm's own kinematics."""

from __future__ import annotations

import numpy as np

from probe.manipulation.kinematics import either_way, reaching
from probe.manipulation.obstacles import Obstacles
from probe.robot_check.carrying import from_above, table_without
from probe.scene.setup import Setup
from probe.station.station import Station
from probe.types import Array

_GRID = 5
_HEIGHTS = (0.03, 0.15)
"""Of the pads' middle above the table, metres."""

_TURNS = np.radians([0.0, 45.0, 90.0, 135.0])


def out_of_reach(station: Station, setup: Setup, lower: Array, upper: Array) -> tuple[Array, int]:
    """Places that no joint angles within the limits reach without the arm touching the table.

    Args:
        station: The arm. It doesn't move.
        setup: The table.
        lower: Joint limits as the robot's bridge tells them, radians, shape (n,).
        upper: The same.

    Returns:
        The places, metres, shape (k, 3), and how many were tried.
    """
    obstacles = Obstacles.of(station.arm, table_without(setup))
    line = np.linspace(-setup.work_area / 2, setup.work_area / 2, _GRID)
    targets = np.array([(x, y, z) for z in _HEIGHTS for x in line for y in line])
    reached = [_reached(station, obstacles, target, lower, upper) for target in targets]
    return targets[~np.array(reached)], len(targets)


def _reached(
    station: Station, obstacles: Obstacles, target: Array, lower: Array, upper: Array
) -> bool:
    above = target + [0.0, 0.0, station.hand.pad_reach(0.0)]
    for turn in _TURNS:
        for pose in either_way(from_above(above, float(turn))):
            for joints in reaching(station.arm, pose, station.arm.parked):
                within = bool(((joints >= lower) & (joints <= upper)).all())
                if within and obstacles.arm_free(joints):
                    return True
    return False
