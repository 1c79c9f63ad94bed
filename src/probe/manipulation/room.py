"""How far a thing can be pushed before something fixed stops it. Moves nothing."""

from __future__ import annotations

import numpy as np

from probe.manipulation.target import Target
from probe.manipulation.terrain import CELL, Terrain
from probe.scene.setup import Basket
from probe.types import Array

_EMPTY = 0.005
_FURTHEST = 1.0


def room_ahead(target: Target, terrain: Terrain, along: Array, basket: Basket) -> float:
    """Metres that a thing and all that it would push along can go before the basket's wall.

    Args:
        target: What is to be pushed.
        terrain: All that is seen.
        along: Unit direction of the push along an axis of the table, shape (3,).
        basket: The basket.
    """
    axis = int(np.abs(along[:2]).argmax())
    sign = float(np.sign(along[axis]))
    wall = sign * basket.position[axis] - basket.size[axis] / 2
    ahead, aside = sign * target.top[:, axis], target.top[:, 1 - axis]
    beside = np.abs(aside - basket.position[1 - axis]) < basket.size[1 - axis] / 2
    if not beside.any() or ahead[beside].mean() > wall:
        return _FURTHEST
    # The empty part of each lane from the thing to the wall; the fullest lane stops it.
    steps = np.arange(float(ahead.min()), wall - 6 * CELL, CELL)
    lanes = np.arange(float(aside[beside].min()), float(aside[beside].max()) + CELL, CELL)
    points = np.zeros((len(lanes), len(steps), 3))
    points[..., axis], points[..., 1 - axis] = sign * steps, lanes[:, None]
    empty = terrain.below(points) < _EMPTY
    return float(empty.sum(axis=1).min()) * CELL
