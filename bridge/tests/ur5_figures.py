"""The practice arm from its published Denavit-Hartenberg figures: another way than the bridge's."""

from __future__ import annotations

import math
from typing import List, Sequence, Tuple

D = (0.089159, 0.0, 0.0, 0.10915, 0.09465, 0.0823)
A = (0.0, -0.425, -0.39225, 0.0, 0.0, 0.0)
ALPHA = (math.pi / 2, 0.0, 0.0, math.pi / 2, -math.pi / 2, 0.0)

Point = Tuple[float, float, float]
Matrix = List[List[float]]


def points(joints: Sequence[float]) -> Tuple[Point, Point, Point, Point]:
    """Flange, point between the pads, elbow and wrist of the practice arm, in the world."""
    world: Matrix = [[-1, 0, 0, -0.5], [0, -1, 0, 0], [0, 0, 1, 0.2], [0, 0, 0, 1]]
    frames: List[Matrix] = []
    for angle, d, a, alpha in zip(joints, D, A, ALPHA):
        world = _times(world, _link(angle, d, a, alpha))
        frames.append(world)
    flange = frames[5]
    return _at(flange, 0.0), _at(flange, 0.22), _at(frames[1], 0.13), _at(frames[2], 0.0)


def _link(angle: float, d: float, a: float, alpha: float) -> Matrix:
    c, s, ca, sa = math.cos(angle), math.sin(angle), math.cos(alpha), math.sin(alpha)
    return [
        [c, -s * ca, s * sa, a * c],
        [s, c * ca, -c * sa, a * s],
        [0.0, sa, ca, d],
        [0.0, 0.0, 0.0, 1.0],
    ]


def _times(one: Matrix, other: Matrix) -> Matrix:
    return [[sum(row[k] * other[k][j] for k in range(4)) for j in range(4)] for row in one]


def _at(frame: Matrix, along_z: float) -> Point:
    x, y, z = (row[3] + along_z * row[2] for row in frame[:3])
    return x, y, z
