"""Rigid transforms without numpy."""

from __future__ import annotations

import math
from typing import NamedTuple, Tuple

from probe_bridge.fields import Vector

Rotation = Tuple[float, float, float, float, float, float, float, float, float]
"""Row by row."""


class Transform(NamedTuple):
    """Rotation, then translation in metres."""

    rotation: Rotation
    position: Vector


def apply(transform: Transform, point: Vector) -> Vector:
    """A point of the inner frame in the outer one."""
    a, b, c, d, e, f, g, h, i = transform.rotation
    x, y, z = point
    px, py, pz = transform.position
    return (
        px + a * x + b * y + c * z,
        py + d * x + e * y + f * z,
        pz + g * x + h * y + i * z,
    )


def compose(first: Transform, second: Transform) -> Transform:
    """``a_from_b`` and ``b_from_c`` to ``a_from_c``."""
    a, b, c, d, e, f, g, h, i = first.rotation
    j, k, m, n, o, p, q, r, s = second.rotation
    rotation = (
        a * j + b * n + c * q,
        a * k + b * o + c * r,
        a * m + b * p + c * s,
        d * j + e * n + f * q,
        d * k + e * o + f * r,
        d * m + e * p + f * s,
        g * j + h * n + i * q,
        g * k + h * o + i * r,
        g * m + h * p + i * s,
    )
    return Transform(rotation, apply(first, second.position))


def about(axis: Vector, angle: float) -> Rotation:
    """Rotation by an angle in radians about a unit axis (Rodrigues' formula)."""
    x, y, z = axis
    c, s = math.cos(angle), math.sin(angle)
    t = 1.0 - c
    return (
        t * x * x + c,
        t * x * y - s * z,
        t * x * z + s * y,
        t * x * y + s * z,
        t * y * y + c,
        t * y * z - s * x,
        t * x * z - s * y,
        t * y * z + s * x,
        t * z * z + c,
    )


def from_rpy(xyz: Vector, rpy: Vector) -> Transform:
    """An origin as a URDF states it: fixed axes x, y, z; radians, metres."""
    roll, pitch, yaw = rpy
    turn = compose(
        Transform(about((0.0, 0.0, 1.0), yaw), (0.0, 0.0, 0.0)),
        compose(
            Transform(about((0.0, 1.0, 0.0), pitch), (0.0, 0.0, 0.0)),
            Transform(about((1.0, 0.0, 0.0), roll), (0.0, 0.0, 0.0)),
        ),
    )
    return Transform(turn.rotation, xyz)


def distance(one: Vector, other: Vector) -> float:
    """Between two points, metres."""
    return math.sqrt(sum((a - b) ** 2 for a, b in zip(one, other)))
