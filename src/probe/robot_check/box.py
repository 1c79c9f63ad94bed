"""A plain box of known size: the thing by which cameras are checked. Moves nothing."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from probe.types import Array, Pose, Vector3


@dataclass(frozen=True)
class KnownBox:
    """A box in a frame of its own: origin in its middle, z upwards as it stands.

    Attributes:
        size: Along x, y and z, metres.
    """

    size: Vector3 = (0.06, 0.06, 0.12)

    @property
    def half(self) -> Array:
        """Half its size, shape (3,)."""
        return np.array(self.size) / 2

    def surface(self, spacing: float) -> Array:
        """Points on all of its sides, about so far apart, shape (n, 3)."""
        axes: list[Array] = [
            np.linspace(-h, h, max(2, round(2 * h / spacing) + 1)) for h in self.half
        ]
        grid: Array = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
        return grid[(np.abs(grid) >= self.half - 1e-9).any(axis=1)]

    def distances(self, points: Array) -> Array:
        """Signed distances of points, shape (n, 3), from its surface; below 0 inside."""
        beyond = np.abs(points) - self.half
        outside = np.linalg.norm(np.maximum(beyond, 0.0), axis=1)
        return outside + np.minimum(beyond.max(axis=1), 0.0)

    def seen_middle(self, world_from_box: Pose, eye: Array) -> Array:
        """Middle of what an eye at a place in the world sees of it, shape (3,), in the world."""
        towards = world_from_box.inverse().apply(eye[None])[0]
        total, weight = np.zeros(3), 0.0
        for axis in range(3):
            side = float(np.sign(towards[axis]))
            depth = abs(float(towards[axis])) - self.half[axis]
            if depth <= 0:
                continue
            middle = np.zeros(3)
            middle[axis] = side * self.half[axis]
            area = float(np.prod(np.delete(self.half, axis)))
            share = area * depth / float(np.linalg.norm(towards - middle)) ** 3
            total, weight = total + share * middle, weight + share
        return world_from_box.apply((total / weight)[None])[0]
