"""What the pads would touch when they close, and how well that would hold. Knows no obstacles."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from probe.manipulation.pairs import HandPoses
from probe.manipulation.target import Target
from probe.types import Array, Vector3

_TOUCH = 0.003
_POINTS = 1200
_FULL_TOUCH = 24
_CHUNK = 128


def close(
    hands: HandPoses, target: Target, pad_half: Vector3, reach: float
) -> tuple[HandPoses, Array]:
    """Close each hand on the target and judge what it touches.

    Args:
        hands: Ways to put the pads around the target.
        target: What they close on.
        pad_half: Half of a pad's width, thickness and length, metres.
        reach: Distance of an open pad from the middle at most, metres.

    Returns:
        The hands, moved along their axes so that both pads touch at once and with the widths
        that leaves; and how well each should hold, shape (n,), -inf where a pad touches nothing.
    """
    step = max(1, -(-len(target.walls) // _POINTS))
    walls, normals = target.walls[::step], target.normals[::step]
    shifts, widths = np.zeros(len(hands.widths)), hands.widths.copy()
    merits = np.full(len(hands.widths), -np.inf)
    for start in range(0, len(widths), _CHUNK):
        some = np.arange(start, min(start + _CHUNK, len(widths)))
        local = _seen_from(hands[some], walls)
        inside = np.all(np.abs(local) < [pad_half[0], reach, pad_half[2]], axis=2)
        y = local[..., 1]
        low = np.where(inside, y, np.inf).min(axis=1)
        high = np.where(inside, y, -np.inf).max(axis=1)
        touched = inside.any(axis=1) & (high > low)
        low, high = np.where(touched, low, 0.0), np.where(touched, high, 0.0)
        shifts[some] = (low + high) / 2
        widths[some] = np.where(touched, high - low, widths[some])
        facing = np.einsum("pk,ck->cp", normals, hands.rotations[some, :, 1])
        left = inside & (y < low[:, None] + _TOUCH) & (facing < -0.5)
        right = inside & (y > high[:, None] - _TOUCH) & (facing > 0.5)
        hold = _hold(local, left, right, np.abs(facing), _FULL_TOUCH / step)
        hold -= _leverage(hands[some], target.centre, local, left | right, widths[some])
        merits[some] = np.where(touched & left.any(axis=1) & right.any(axis=1), hold, -np.inf)
    centres = hands.centres + shifts[:, None] * hands.rotations[:, :, 1]
    return replace(hands, centres=centres, widths=widths), merits


def _seen_from(hands: HandPoses, points: Array) -> Array:
    """Points in the frame of each hand with the origin between the pads, shape (n, p, 3)."""
    moved = points[None] - hands.centres[:, None]
    return np.matmul(moved, hands.rotations)


def _hold(local: Array, left: Array, right: Array, facing: Array, full: float) -> Array:
    """Flush, large, well opposed contacts on both sides hold best; shape (n,)."""
    merit = np.zeros(len(local))
    counts = np.stack([left.sum(axis=1), right.sum(axis=1)])
    merit += 0.6 * np.minimum(counts.min(axis=0) / full, 1.0)
    sides = np.stack([left, right])
    flush: Array = (sides * facing).sum(axis=2) / np.maximum(sides.sum(axis=2), 1)
    merit += flush.min(axis=0)
    offset = _mean(local, left) - _mean(local, right)
    return merit - 20.0 * np.maximum(np.abs(offset[:, 0]) - 0.004, 0.0)


def _leverage(
    hands: HandPoses, centre: Array, local: Array, touched: Array, widths: Array
) -> Array:
    """Cost of holding away from the centre of mass, shape (n,)."""
    middle = _seen_from(hands, centre[None])[:, 0]
    contact = _mean(local, touched)
    # What hangs straight below the pads turns nothing.
    down = np.array([0.0, 0.0, -1.0]) @ hands.rotations
    away = middle - contact
    away -= (away * down).sum(axis=1, keepdims=True) * down
    beside = np.maximum(np.abs(away[:, 1]) - widths / 2, 0.0)
    return 10.0 * np.abs(away[:, 0]) + 5.0 * beside


def _mean(points: Array, chosen: Array) -> Array:
    count = np.maximum(chosen.sum(axis=1), 1)[:, None]
    return (points * chosen[..., None]).sum(axis=1) / count
