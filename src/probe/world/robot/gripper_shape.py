"""The Robotiq 2F-140 as boxes, for its model and for collision checks. Knows no engine.

Sizes enclose the maker's parts. Each solid is in the frame of its own part at the finger on the
-y side: cranks with z along the crank, the inner finger with the gripper's axes.
"""

from __future__ import annotations

import math

import numpy as np

from probe.scene.setup import GripperSize
from probe.types import Array, Vector3
from probe.world.robot.gripper import (
    INNER_PIVOT,
    PAD_CENTRE,
    PIVOT,
    ROBOTIQ_2F140,
    TILT,
    crank,
    joint_for,
    pad_half,
)
from probe.world.robot.solids import BLACK, GREY, RUBBER, SILVER, Cylinder, SolidBox

PALM = (
    Cylinder((0.0, 0.0, 0.0), (0.0, 0.0, 0.046), 0.0375, BLACK),
    SolidBox((0.0, 0.0, 0.058), (0.0125, 0.0424, 0.012), GREY),
    SolidBox((0.0, 0.0, 0.080), (0.0105, 0.0260, 0.010), GREY),
)
_OUTER_CRANK = (
    SolidBox((0.0, -0.005, 0.002), (0.0120, 0.020, 0.016), SILVER),
    SolidBox((0.0, -0.017, 0.045), (0.0125, 0.012, 0.027), BLACK),
    SolidBox((0.0, -0.004, 0.088), (0.0125, 0.010, 0.018), BLACK),
)
_INNER_CRANK = (SolidBox((0.0, 0.0, 0.050), (0.0150, 0.006, 0.056), BLACK),)
INNER_FINGER = (SolidBox((0.0, 0.009, 0.019), (0.0075, 0.0149, 0.025), BLACK),)

SLICES = 3  # pieces that a tilted crank is cut into before it is boxed


def outer_crank(size: GripperSize) -> tuple[SolidBox, ...]:
    """What an outer crank is made of."""
    return _stretched(_OUTER_CRANK, size)


def inner_crank(size: GripperSize) -> tuple[SolidBox, ...]:
    """What an inner crank is made of."""
    return _stretched(_INNER_CRANK, size)


def pad(size: GripperSize) -> SolidBox:
    """A pad."""
    return SolidBox((0.0, *PAD_CENTRE), pad_half(size), RUBBER)


def boxes(opening: float, size: GripperSize = ROBOTIQ_2F140) -> list[tuple[Array, Array]]:
    """What the gripper occupies, on the safe side.

    Args:
        opening: Distance between the pads, metres.
        size: The gripper's.

    Returns:
        Centres and half sizes, each of shape (3,), of boxes along the axes of tool0: the palm
        first, then both fingers.
    """
    joint = joint_for(opening, size)
    finger = [
        _bounds(_corners(box, joint, pivot))
        for solids, pivot in ((outer_crank(size), PIVOT), (inner_crank(size), INNER_PIVOT))
        for solid in solids
        for box in _cut(solid)
    ]
    end = _crank_end(joint, crank(size))
    finger += [_bounds(solid.corners + end) for solid in (*INNER_FINGER, pad(size))]
    mirror = np.array([1.0, -1.0, 1.0])
    return [_palm(), *finger, *((centre * mirror, half) for centre, half in finger)]


def _stretched(solids: tuple[SolidBox, ...], size: GripperSize) -> tuple[SolidBox, ...]:
    """A crank's solids at the length that a size gives it."""
    factor = crank(size) / crank(ROBOTIQ_2F140)
    return tuple(
        SolidBox(
            (*solid.centre[:2], factor * solid.centre[2]),
            (*solid.half_size[:2], factor * solid.half_size[2]),
            solid.colour,
        )
        for solid in solids
    )


def _palm() -> tuple[Array, Array]:
    return np.array([0.0, 0.0, 0.045]), np.array([0.0375, 0.0424, 0.045])


def _bounds(points: Array) -> tuple[Array, Array]:
    low, high = points.min(axis=0), points.max(axis=0)
    return (low + high) / 2, (high - low) / 2


def _cut(box: SolidBox) -> list[SolidBox]:
    """The box in slices along z."""
    x, y, z = box.half_size
    half: Vector3 = (x, y, z / SLICES)
    heights = box.centre[2] + z * (np.arange(1, 2 * SLICES, 2) / SLICES - 1)
    return [SolidBox((*box.centre[:2], float(height)), half, box.colour) for height in heights]


def _corners(box: SolidBox, joint: float, pivot: tuple[float, float]) -> Array:
    """Corners of a crank's box in the gripper's frame, shape (8, 3)."""
    x, y, z = box.corners.T
    c, s = math.cos(TILT - joint), math.sin(TILT - joint)
    return np.column_stack([x, c * y - s * z - pivot[0], s * y + c * z + pivot[1]])


def _crank_end(joint: float, length: float) -> Array:
    tilt = TILT - joint
    return np.array([0.0, -PIVOT[0] - length * math.sin(tilt), PIVOT[1] + length * math.cos(tilt)])
