"""Spheres that cover an arm's links. Knows no particular arm."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from probe.types import Array
from probe.world.robot.solids import Cylinder

_SPACING = 0.05


def cover(solids: Sequence[Cylinder]) -> Array:
    """Spheres along the axes of cylinders: x, y, z, radius, shape (k, 4), in their link's frame."""
    rows: list[Array] = []
    for solid in solids:
        start, end = np.array(solid.start), np.array(solid.end)
        count = max(2, int(np.ceil(np.linalg.norm(end - start) / _SPACING)) + 1)
        centres = np.linspace(start, end, count)
        rows.append(np.column_stack([centres, np.full(count, solid.radius)]))
    return np.concatenate(rows)


def placed(spheres: Array, world_from_link: Array) -> Array:
    """Spheres of a link's frame, shape (k, 4), in the world; the frame's matrix is (4, 4)."""
    centres = spheres[:, :3] @ world_from_link[:3, :3].T + world_from_link[:3, 3]
    return np.column_stack([centres, spheres[:, 3]])
