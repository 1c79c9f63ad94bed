"""The closed hand in one orientation, as a tool that pushes. Knows no target."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from probe.manipulation.handshape import HandShape
from probe.types import Array

SIDE = 0.002
"""Metres by which it keeps clear of what stands beside it."""

_TIP = 0.012


@dataclass(frozen=True, eq=False)
class ClosedHand:
    """The closed hand in one orientation.

    Attributes:
        rotation: world_from_hand, shape (3, 3).
        points: On the hand from its frame's origin, along the world's axes, shape (n, 3).
        front: How far the tips reach along the push.
        half: Half of the tips' width across it.
        middle: Where the tips' middle lies aside of the origin.
        bottom: How far the tips reach down; below 0.
        tips: Those points that lie on the tips' ends, shape (k, 3).
    """

    rotation: Array
    points: Array
    front: float
    half: float
    middle: float
    bottom: float
    tips: Array

    @staticmethod
    def of(shape: HandShape, rotation: Array, along: Array, aside: Array) -> ClosedHand:
        points = shape.whole(0.0) @ rotation.T
        ends = shape.tips(0.0) @ rotation.T
        bottom = float(ends[:, 2].min())
        tips = points[points[:, 2] < bottom + _TIP]
        across = tips @ aside
        low, high = float(across.min()), float(across.max())
        front = float((tips @ along).max())
        return ClosedHand(rotation, points, front, (high - low) / 2, (high + low) / 2, bottom, ends)


def orientation(lean: float, towards: Array, closing: Array) -> Array:
    """world_from_hand with the tips leading towards a side and the pads closing along another."""
    approach = np.sin(lean) * towards - np.cos(lean) * np.array([0.0, 0.0, 1.0])
    axis = closing - approach * (closing @ approach)
    axis /= np.linalg.norm(axis)
    return np.column_stack([np.cross(axis, approach), axis, approach])
