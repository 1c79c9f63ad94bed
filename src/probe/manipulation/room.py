"""How far a thing can be pushed before something fixed stops it. Moves nothing."""

from __future__ import annotations

import numpy as np

from probe.manipulation.target import Target
from probe.manipulation.terrain import CELL, Terrain
from probe.scene.layout import BASKET_SIZE
from probe.types import Array, Vector3

_EMPTY = 0.005
_FURTHEST = 1.0


def room_ahead(target: Target, terrain: Terrain, along: Array, basket: Vector3) -> float:
    """Metres that a thing and all that it would push along can go before the basket's wall.

    Args:
        target: What is to be pushed.
        terrain: All that is seen.
        along: Unit direction of the push along an axis of the table, shape (3,).
        basket: Middle of the basket's floor.
    """
    axis = int(np.abs(along[:2]).argmax())
    sign = float(np.sign(along[axis]))
    wall = sign * basket[axis] - BASKET_SIZE[axis] / 2
    ahead, aside = sign * target.top[:, axis], target.top[:, 1 - axis]
    beside = np.abs(aside - basket[1 - axis]) < BASKET_SIZE[1 - axis] / 2
    if not beside.any() or ahead[beside].mean() > wall:
        return _FURTHEST
    # The empty part of each lane from the thing to the wall; the fullest lane stops it.
    steps = np.arange(float(ahead.min()), wall - 6 * CELL, CELL)
    lanes = np.arange(float(aside[beside].min()), float(aside[beside].max()) + CELL, CELL)
    points = np.zeros((len(lanes), len(steps), 3))
    points[..., axis], points[..., 1 - axis] = sign * steps, lanes[:, None]
    empty = terrain.below(points) < _EMPTY
    return float(empty.sum(axis=1).min()) * CELL
