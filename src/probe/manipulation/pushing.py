"""Where a closed gripper could start to push a thing. Moves nothing.

Along: in the push's direction. Aside: to its left. Both level, lengths in metres.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from probe.manipulation.closedhand import SIDE, ClosedHand, orientation
from probe.manipulation.handshape import HandShape
from probe.manipulation.target import Target
from probe.manipulation.terrain import Terrain
from probe.types import Array, Pose, quaternion_of

DESCENT = 0.10
"""Length of the straight way down, metres."""

_GAPS = np.array([4, 8, 12, 18, 25, 35, 45, 60, 80, 100, 125, 160, 200, 250]) / 1000
_ASIDE = np.array([0, 8, -8, 16, -16, 26, -26, 38, -38, 52, -52]) / 1000
_DOWN = np.array([0.0, 0.03, DESCENT])
_AHEAD = np.array([0.3, 0.6, 1.0])
_LOWEST, _HIGHEST = 0.0015, 0.012
_OVERLAP = 0.003
_REAR = 0.02
_KNUCKLES = 0.04


@dataclass(frozen=True)
class PlannedPush:
    """A push of the closed gripper.

    Attributes:
        start: world_from_hand behind the thing.
        gap: Metres until it touches.
        cost: Lower is better; comparable within one call only.
        pressed: It comes down on the thing itself and goes on down until it feels it.
        through: It meets other things before this one.
    """

    start: Pose
    gap: float
    cost: float
    pressed: bool = False
    through: bool = False


@dataclass(frozen=True, eq=False)
class _Surroundings:
    """What a push has to do with.

    Attributes:
        target: What is to be pushed.
        along, aside: Unit vectors, shape (3,).
        distance: How far.
        full: All that is seen, with a margin.
        bare: The same without the target.
    """

    target: Target
    along: Array
    aside: Array
    distance: float
    full: Terrain
    bare: Terrain


def pushes(
    target: Target, terrain: Terrain, shape: HandShape, along: Array, distance: float
) -> Iterator[PlannedPush]:
    """Places to push from: upright ones first, the best first within each lean.

    Args:
        target: What is to be pushed.
        terrain: All that is seen.
        shape: The gripper's.
        along: Unit direction of the push, level, shape (3,).
        distance: How far it is to be pushed, metres.
    """
    if len(target.top) == 0:
        return
    aside = np.array([-along[1], along[0], 0.0])
    full, bare = terrain.widened(SIDE), terrain.without(target.cells).widened(SIDE)
    around = _Surroundings(target, along, aside, distance, full, bare)
    for lean_deg, towards in (
        (0.0, along), (30.0, along), (30.0, aside), (30.0, -aside), (50.0, along), (50.0, aside),
        (50.0, -aside),
    ):  # fmt: skip
        found: list[PlannedPush] = []
        for across, cost in ((along, 0.0), (aside, 0.05)):
            rotation = orientation(np.radians(lean_deg), towards, across)
            tool = ClosedHand.of(shape, rotation, along, aside)
            found += [push for line in _ASIDE for push in _on_line(tool, around, line, cost)]
        yield from sorted(found, key=lambda push: push.cost)


def _on_line(
    tool: ClosedHand, around: _Surroundings, line: float, cost: float
) -> Iterator[PlannedPush]:
    """The nearest free spot at each height behind the target, on a line beside its middle."""
    target = around.target
    aside = float(target.centre @ around.aside) + line
    own = target.top[np.abs(target.top @ around.aside - aside) <= tool.half + 0.001]
    if len(own) == 0:
        return
    rear = float((own @ around.along).min())
    for number, height in enumerate(_heights(own, around)):
        at = own[own[:, 2] > height + _OVERLAP / 2] @ around.along
        if len(at) == 0:
            continue
        if at.min() > rear + _REAR:
            continue
        contact = around.along * (float(at.min()) - tool.front)
        contact = contact + around.aside * (aside - tool.middle)
        contact[2] = height - tool.bottom
        gap = _free_gap(tool, around, contact)
        if gap is not None:
            start = Pose.of(contact - gap * around.along, quaternion_of(tool.rotation))
            total = cost + 3.0 * gap + 8.0 * abs(line) + 0.25 * number
            through, hindrance = _hindrance(tool, around, contact, gap)
            yield PlannedPush(start, gap, total + hindrance, through=through)


def _heights(own: Array, around: _Surroundings) -> list[float]:
    """Heights for the tips: low behind the target, and just below its rear edge."""
    at = own @ around.along
    rear = own[at < at.min() + _REAR]
    behind = rear[:, :3] - around.along * (_REAR + 0.005)
    top = float(rear[:, 2].max())
    # What stands behind it may be taller than it is: then it stands no higher than its own edge.
    ground = min(float(np.percentile(around.bare.below(behind), 30)), top - 2 * _OVERLAP)
    ground = max(ground, 0.0)
    low = ground + float(np.clip(0.35 * (top - ground), _LOWEST, _HIGHEST))
    skim = top - _OVERLAP
    return [low] if skim < low + 0.004 else [low, (low + skim) / 2, skim]


def _free_gap(tool: ClosedHand, around: _Surroundings, contact: Array) -> float | None:
    """Smallest distance behind the contact at which the hand can come down."""
    for gap in _GAPS:
        down = contact - gap * around.along + _DOWN[:, None] * np.array([0.0, 0.0, 1.0])
        if _above(around.full, tool.points, down).all():
            return float(gap)
    return None


def _hindrance(
    tool: ClosedHand, around: _Surroundings, contact: Array, gap: float
) -> tuple[bool, float]:
    """Whether other things are met on the way, and the cost of that and of touching too much."""
    behind = contact - np.linspace(0.0, gap, 5)[:, None] * around.along
    through = not _above(around.bare, tool.points, behind).all()
    ahead = contact + (_AHEAD * around.distance)[:, None] * around.along
    met = 1.0 - float(_above(around.bare, tool.points, ahead).mean())
    upper = tool.points[tool.points[:, 2] > tool.bottom + _KNUCKLES]
    knuckles = not _above(around.full, upper, (contact - 0.003 * around.along)[None])[0]
    return through, 1.0 * through + 0.2 * met + 0.4 * knuckles


def _above(terrain: Terrain, points: Array, origins: Array) -> Array:
    """Whether points moved to each origin, shape (n, 3), lie above the terrain, shape (n,)."""
    world = points[None] + origins[:, None]
    above: Array = world[..., 2] > terrain.below(world) + 0.001
    return np.all(above, axis=1)
