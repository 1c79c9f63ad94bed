"""Where a closed gripper could press on a thing from above and take it along. Moves nothing.

This needs no free spot behind the thing: its tips come down on it, or into it where it is hollow,
and friction or the wall ahead takes it with them. What is round would roll away beneath them.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from scipy import ndimage

from probe.manipulation.closedhand import SIDE, ClosedHand, orientation
from probe.manipulation.handshape import HandShape
from probe.manipulation.pushing import PlannedPush
from probe.manipulation.target import Target
from probe.manipulation.terrain import CELL, Terrain
from probe.types import Array, Pose, quaternion_of

_ABOVE = 0.002
"""Where the tips begin to feel for the surface, metres above where it is seen."""

_LEANS_DEG = (0.0, 25.0, -25.0)
_EVERY = 3
_TOUCHING = 0.003
_FLAT = 0.004
_WALL = 0.006


def drags(
    target: Target, terrain: Terrain, shape: HandShape, along: Array
) -> Iterator[PlannedPush]:
    """Places to press on, the best first: flat, in the middle, or with a wall of its own ahead.

    Args:
        target: What is to be taken along.
        terrain: All that is seen.
        shape: The gripper's.
        along: Unit direction, level, shape (3,).
    """
    if len(target.top) == 0:
        return
    aside = np.array([-along[1], along[0], 0.0])
    mine = ndimage.binary_dilation(target.cells, iterations=round(SIDE / CELL))
    others = terrain.without(target.cells).widened(SIDE)
    found: list[PlannedPush] = []
    for lean in _LEANS_DEG:
        for across in (along, aside):
            tool = ClosedHand.of(shape, orientation(np.radians(lean), along, across), along, aside)
            found += _spots(target, terrain, others, mine, tool, along, abs(lean))
    yield from sorted(found, key=lambda push: push.cost)


def _spots(
    target: Target,
    terrain: Terrain,
    others: Terrain,
    mine: Array,
    tool: ClosedHand,
    along: Array,
    lean: float,
) -> Iterator[PlannedPush]:
    """Where the tool, let down, would touch the target with its tips and nothing else."""
    tips = tool.tips
    middle = (tips.min(axis=0) + tips.max(axis=0)) / 2
    for spot in target.top[::_EVERY]:
        at = spot - middle
        at[2] = 0.0
        # How high each point stands where the tool touches there.
        rest = terrain.below(tips + at) - tips[:, 2]
        height = float(rest.max())
        touching = rest > height - _TOUCHING
        if not mine[terrain.cells((tips + at)[touching, :2])].all():
            continue
        at[2] = height
        hand = tool.points + at
        if (hand[:, 2] < others.below(hand) + 0.001).any():
            continue
        upper = hand[hand[:, 2] > height + tool.bottom + _FLAT]
        if (upper[:, 2] < terrain.below(upper)).any():
            continue
        gap = _wall(target, tool, at, along)
        off = float(np.linalg.norm((spot - target.centre)[:2]))
        flat = float((rest > height - _FLAT).mean())
        cost = 5.0 * off - 0.3 * flat - (0.3 if gap > 0 else 0.0) + 0.01 * lean
        at[2] += _ABOVE
        yield PlannedPush(Pose.of(at, quaternion_of(tool.rotation)), gap, cost, pressed=True)


def _wall(target: Target, tool: ClosedHand, at: Array, along: Array) -> float:
    """Metres until the tips meet a wall of the thing itself; 0 without one."""
    aside = np.array([-along[1], along[0], 0.0])
    own, front = target.top, float(at @ along) + tool.front
    lane = np.abs(own @ aside - at @ aside - tool.middle) < tool.half
    high = own[:, 2] > at[2] + tool.bottom + _WALL
    ahead = (own @ along)[lane & high] - front
    ahead = ahead[ahead > 0]
    return float(ahead.min()) if len(ahead) else 0.0
