"""What became of a thing between two looks at the table, by depth alone. Knows no names."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from scipy import ndimage
from scipy.spatial.transform import Rotation

from probe.manipulation.registration import Motions, OrientedPoints, fit, register
from probe.manipulation.terrain import lifted
from probe.perception.depths import depth_change, same_within, tolerance
from probe.types import Array, Frame

SAME = 0.003
"""Metres by which a pixel's depth may differ and still show the same."""

NOWHERE = np.zeros(3)
"""A way of no length: the thing may have stayed about where it was."""

_POINTS, _FEW = 200, 60
_STEP = 0.06
_TIPS = np.radians([0.0, 25.0, -25.0, 50.0])
_TURNS = np.radians([0.0, 20.0, -20.0, 40.0, -40.0])
_ROUGH = 0.012
_SLACK, _SLACK_LIMITS = 0.15, (0.002, 0.004)
_TRIED, _KEPT = 12, 3
_SLIDES = (np.arange(-4, 5) * 0.010, np.arange(-4, 5) * 0.005, np.arange(-3, 4) * 0.002)
_HIDING_COST = 0.5
_FOUND = 0.5
_ON_TABLE = 0.0015
_UP = np.array([0.0, 0.0, 1.0])


def still_there(before: Frame, after: Frame, mask: Array) -> float:
    """Share of a mask's pixels whose depth is as it was, 0 to 1."""
    change = np.abs(depth_change(before, after)[mask])
    return float(np.mean(change < same_within(SAME, before, after))) if change.size else 0.0


@dataclass(frozen=True, eq=False)
class Found:
    """A thing seen again.

    Attributes:
        mask: Which pixels show it, bool, shape (h, w).
        shift: How its middle moved, metres, shape (3,).
        merit: How well its shape agrees with what is seen, up to 1; 0 where it wasn't asked.
    """

    mask: Array
    shift: Array
    merit: float


def changed(before: Frame, after: Frame, mask: Array) -> Array:
    """What may show a thing that a mask showed, bool, shape (h, w).

    What showed something else before, and shows it still, doesn't.
    """
    return mask | (np.abs(depth_change(before, after)) > same_within(SAME, before, after))


def above_table(frame: Frame) -> Array:
    """Pixels that show more than the bare table, bool, shape (h, w)."""
    least = tolerance(_ON_TABLE, frame.depth_noise)
    if frame.camera.looks_down:
        return frame.depth < frame.camera.world_from_camera.position[2] - least
    points = lifted(frame, np.ones_like(frame.depth, bool))
    return points[:, 2].reshape(frame.depth.shape) > least


def tracked(
    before: Frame,
    after: Frame,
    mask: Array,
    way: Array = NOWHERE,
    where: Array | None = None,
    least: float = _FOUND,
) -> Found | None:
    """Find a thing again that may have slid, turned and tipped on the table.

    Args:
        before: Where the mask is known.
        after: Where it is looked for: on the way and a few centimetres beside it, turned by up to
            some 60 degrees, tipped by up to some 45.
        mask: bool, shape (h, w).
        way: A straight line from where it was, on which it may have stopped anywhere, metres,
            shape (3,).
        where: Pixels that may show it, bool, shape (h, w); None for all of them.
        least: Merit that it must have.

    Returns:
        None if it isn't found.
    """
    possible = changed(before, after, mask) & above_table(after)
    possible &= True if where is None else where
    points = lifted(before, mask)
    if len(points) == 0 or not possible.any():
        return None
    few = points[:: max(1, len(points) // _POINTS)]
    surface = OrientedPoints.of(after, possible)
    # A tall thing may have tipped a little; a flat one would be taken for what it lies on.
    slack = float(np.clip(_SLACK * points[:, 2].max(), *_SLACK_LIMITS))
    slack = same_within(slack, before, after)
    motion, merit = _placed(surface, few, way, slack)
    if merit < least:
        return None
    rows, columns, _, inside = surface.under(motion.apply(points)[0])
    shown = np.zeros_like(mask, bool)
    top, left = surface.corner
    shown[rows[inside] + top, columns[inside] + left] = True
    shift = motion.apply(few)[0].mean(axis=0) - few.mean(axis=0)
    return Found(ndimage.binary_closing(shown, iterations=2), shift, merit)


def _placed(
    surface: OrientedPoints, points: Array, way: Array, slack: float
) -> tuple[Motions, float]:
    """The motion that explains best what is seen, and how well: slid and turned, or tipped."""
    few = points[:: max(1, len(points) // _FEW)]
    slid = _best(
        surface, few, _guesses(points, way, _TIPS[:1]).slid(_grid(_SLIDES[0])), slack, _TRIED
    )
    tipped = _best(surface, few, _guesses(points, way, _TIPS[1:]), _ROUGH, _TRIED)
    guesses = slid.and_also(tipped)
    settled = register(surface, points, guesses)
    motions = _best(surface, points, guesses.and_also(settled), slack, _KEPT)
    # A plane slides on itself unnoticed; where it ends tells how far it went.
    for slide in _SLIDES[1:]:
        motions = _best(surface, points, motions.slid(_grid(slide)), slack, _KEPT)
    motions = motions.and_also(register(surface, points, motions))
    best = _best(surface, points, motions, slack, 1)
    return best, float(_merits(surface, points, best, slack)[0])


def _guesses(points: Array, way: Array, tips: Array) -> Motions:
    """Where a thing may be now: stops along the way, tips about its middle, turns."""
    length = float(np.linalg.norm(way))
    hinge = np.cross(_UP, way / length) if length > 0 else np.array([0.0, 1.0, 0.0])
    turned = [
        (Rotation.from_rotvec(tip * hinge) * Rotation.from_rotvec(turn * _UP)).as_matrix()
        for tip in tips
        for turn in _TURNS
    ]
    stops = np.linspace(0, 1, math.ceil(length / _STEP) + 1)[:, None] * way
    rotations = np.tile(np.stack(turned), (len(stops), 1, 1))
    return Motions(rotations, np.repeat(stops, len(turned), axis=0), points.mean(axis=0))


def _grid(steps: Array) -> Array:
    """Shifts over the table by every pair of steps, shape (k, 3)."""
    x, y = (part.ravel() for part in np.meshgrid(steps, steps))
    return np.column_stack([x, y, np.zeros(len(x))])


def _best(
    surface: OrientedPoints, points: Array, motions: Motions, slack: float, count: int
) -> Motions:
    order = np.argsort(-_merits(surface, points, motions, slack), kind="stable")
    return motions[order[:count]]


def _merits(surface: OrientedPoints, points: Array, motions: Motions, slack: float) -> Array:
    shown, hiding = fit(surface, points, motions, slack)
    return shown - _HIDING_COST * hiding
