"""The hand as points that must stay out of things. Knows no arm.

Frame: the hand's, z out of it, the fingers close along y.
"""

from __future__ import annotations

import numpy as np

from probe.station.station import Hand
from probe.types import Array

_SPACING = 0.018
_FINE = 0.007
_SWEPT = 0.005
_MIRROR = np.array([1.0, -1.0, 1.0])


class HandShape:
    """Points on a hand at any opening; remembers those it was asked for."""

    def __init__(self, hand: Hand) -> None:
        self.hand = hand
        self._whole: dict[float, Array] = {}
        self._pad = surface_points(np.array(hand.pad_half), _FINE)
        self._tip = self._pad[self._pad[:, 2] == hand.pad_half[2]]

    def whole(self, opening: float) -> Array:
        """Points on the whole hand, shape (n, 3)."""
        if opening not in self._whole:
            boxes = self.hand.boxes(opening)
            parts = [surface_points(half, _SPACING) + centre for centre, half in boxes]
            self._whole[opening] = np.concatenate([*parts, self._both(self._pad, opening)])
        return self._whole[opening]

    def tips(self, opening: float) -> Array:
        """Points on the ends of both pads, shape (n, 3)."""
        return self._both(self._tip, opening)

    def swept(self, opening: float, width: float) -> Array:
        """Points within what the pads pass through while they close on a width, shape (n, 3)."""
        x_half, thickness, z_half = self.hand.pad_half
        x = np.linspace(-x_half, x_half, 5)
        y = np.arange(width / 2, opening / 2 + 2 * thickness, _SWEPT)
        z = self.hand.pad_reach(width) + np.linspace(-z_half, z_half, 6)
        one = np.stack(np.meshgrid(x, y, z, indexing="ij"), axis=-1).reshape(-1, 3)
        return np.concatenate([one, one * _MIRROR])

    def _both(self, points: Array, opening: float) -> Array:
        """Points of a pad, seen from its middle, on both pads."""
        y = opening / 2 + self.hand.pad_half[1]
        one = points + np.array([0.0, y, self.hand.pad_reach(opening)])
        return np.concatenate([one, one * _MIRROR])


def surface_points(half: Array, spacing: float) -> Array:
    """Points on a box around the origin, at most so far apart, none on its back (-z)."""
    counts = np.maximum(np.ceil(2 * half / spacing).astype(int) + 1, 2)
    axes: list[Array] = [np.linspace(-h, h, int(n)) for h, n in zip(half, counts, strict=True)]
    grid: Array = np.stack(np.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, 3)
    on_side = (np.abs(grid[:, :2]) == half[:2]).any(axis=1)
    return grid[on_side | (grid[:, 2] == half[2])]
