"""Whether a thing lies otherwise than it did: judged by outline and depth. Knows no names."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

from probe.manipulation.looking import SAME
from probe.manipulation.registration import Motions
from probe.manipulation.terrain import lifted
from probe.perception.depths import same_within
from probe.types import Array, Frame

_POINTS = 100
_GOLDEN = (5**0.5 - 1) / 2
_EXTENT = (2, 98)
"""Percentiles that stand for a thing's ends: a few stray points don't count."""
_BEYOND, _STOPS = 0.01, 13
_TURNS, _TURN_STEP = np.radians([-15.0, -7.5, 0.0, 7.5, 15.0]), np.radians(7.5)
_KEPT, _ROUNDS = 8, 3
_LEVEL = 0.008
"""Metres by which a thing that is hardly tipped may rise above where it would be if it slid."""
_UNEXPLAINED = 0.25
"""Share of a thing's points that may be amiss after the best slide; edges alone take some 3 %."""


def lies_otherwise(before: Frame, after: Frame, was: Array, now: Array) -> bool:
    """Whether no slide explains how a thing shows that has moved: it has turned or tipped as well.

    Each slide that brings what showed of it to where it shows now is tried, with turns of up to
    some 20 degrees. If the thing has only slid, its points come to lie on itself or behind what
    hides them, and so do those that show now if the slide is undone. It may have been hidden in
    part before, or be so now.

    Args:
        before: The first frame.
        after: The second frame.
        was: What the first one shows of the thing, bool, shape (h, w).
        now: What the second one shows of it, bool, shape (h, w).
    """
    there, here = _some(lifted(before, was)), _some(lifted(after, now))
    steps, motions = _slides(there, here)
    slack, turn = same_within(SAME, before, after), _TURN_STEP

    def amiss(tried: Motions) -> Array:
        forth = _amiss(after, now, tried.apply(there), slack)
        return np.maximum(forth, _amiss(before, was, _undone(tried, here), slack))

    for _ in range(_ROUNDS):
        best = motions[np.argsort(amiss(motions), kind="stable")[:_KEPT]]
        steps, turn = steps / 2, turn / 2
        motions = _around(best, steps, turn)
    return bool(amiss(motions).min() > _UNEXPLAINED)


def _some(points: Array) -> Array:
    """At most _POINTS of them, spread so that no row or column of the picture is preferred."""
    if len(points) <= _POINTS:
        return points
    return points[(np.arange(1, _POINTS + 1) * _GOLDEN % 1 * len(points)).astype(int)]


def _slides(there: Array, here: Array) -> tuple[Array, Motions]:
    """The steps along x and y, metres, shape (2,), and slides between points, shapes (n, 3).

    Where one look shows a part of what the other shows, its extents lie within the other's.
    """
    (low, high), (low_now, high_now) = (np.percentile(p, _EXTENT, axis=0) for p in (there, here))
    first, last = low_now - low, high_now - high
    least, most = np.minimum(first, last) - _BEYOND, np.maximum(first, last) + _BEYOND
    across: list[Array] = [np.linspace(least[axis], most[axis], _STOPS) for axis in (0, 1)]
    grid = np.meshgrid(*across, (0.0, last[2]))
    shifts = np.column_stack([part.ravel() for part in grid])
    start = Motions(np.eye(3)[None], np.zeros((1, 3)), there.mean(axis=0))
    return (most - least)[:2] / (_STOPS - 1), _turned(start.slid(shifts), _TURNS)


def _around(motions: Motions, steps: Array, turn: float) -> Motions:
    """Each motion, and others that differ from it by a step along x and y and by a turn."""
    x, y = (part.ravel() for part in np.meshgrid(*(step * np.array([-1, 0, 1]) for step in steps)))
    slides = np.column_stack([x, y, np.zeros(len(x))])
    return _turned(motions.slid(slides), turn * np.array([-1, 0, 1]))


def _turned(motions: Motions, angles: Array) -> Motions:
    """Each motion followed by each turn about the vertical through where it takes the pivot."""
    upright = np.outer(angles, (0.0, 0.0, 1.0))
    rotations: Array = Rotation.from_rotvec(upright).as_matrix()
    turned = np.einsum("aij,njk->naik", rotations, motions.rotations).reshape(-1, 3, 3)
    return Motions(turned, np.repeat(motions.shifts, len(angles), axis=0), motions.pivot)


def _undone(motions: Motions, points: Array) -> Array:
    """Where points, shape (k, 3), were before each motion, shape (n, k, 3)."""
    moved = points - (motions.pivot + motions.shifts)[:, None]
    return np.einsum("nji,nkj->nki", motions.rotations, moved) + motions.pivot


def _amiss(frame: Frame, own: Array, points: Array, slack: float) -> Array:
    """Share of points that can't be where they are, shape (n,).

    They would show beside the thing where nothing hides them, or high above its surface.

    Args:
        frame: What is seen.
        own: What it shows of the thing, bool, shape (h, w).
        points: Of the thing, world, metres, shape (n, k, 3).
        slack: By how much a depth may differ and still be the same, metres.
    """
    flat, camera = points.reshape(-1, 3), frame.camera
    pose = camera.world_from_camera
    columns, rows = np.floor(camera.project(flat)).astype(int).T
    height, width = own.shape
    inside = (rows >= 0) & (rows < height) & (columns >= 0) & (columns < width)
    rows, columns = np.clip(rows, 0, height - 1), np.clip(columns, 0, width - 1)
    higher = frame.depth[rows, columns] - (flat - np.array(pose.position)) @ pose.rotation[:, 2]
    shows = np.where(own[rows, columns], higher > _LEVEL + slack, higher > -slack)
    share: Array = (inside & shows).reshape(points.shape[:2]).mean(axis=1)
    return share
