"""A painted table as a depth camera measures it: noise, holes at edges, readings in steps."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy import ndimage

from probe.station.fusing import FRAMES, fused
from probe.types import Array, Frame
from tabletops import PaintedStation, paint

STEP = 1e-4
"""Steps in which depth is read, metres."""


def measured(exact: Frame, sigma: float, rng: np.random.Generator) -> Frame:
    """A frame fused of several that err by sigma metres and lack half the pixels at edges."""
    jump = ndimage.maximum_filter(exact.depth, 5) - ndimage.minimum_filter(exact.depth, 5)
    told = fused([_reading(exact.depth, jump > 0.004, sigma, rng) for _ in range(FRAMES)])
    return replace(exact, depth=told.depth, depth_noise=told.noise, measured=told.measured)


def _reading(depth: Array, edges: Array, sigma: float, rng: np.random.Generator) -> Array:
    read = np.round((depth + sigma * rng.standard_normal(depth.shape)) / STEP) * STEP
    holes = edges & (rng.random(depth.shape) < 0.5)
    return np.where(holes, rng.choice([0.0, np.nan], depth.shape), read).astype(np.float32)


class NoisyStation(PaintedStation):
    """A PaintedStation with small pictures, each look of which errs anew."""

    def __init__(self, blocks, setup, sigma: float, seed: int = 0) -> None:
        super().__init__(blocks)
        self._setup, self._sigma = setup, sigma
        self._rng = np.random.default_rng(seed)

    def observe(self, *, rgb: bool) -> Frame:
        exact = paint(self.blocks, rgb=rgb, camera=self._setup.camera())
        return measured(exact, self._sigma, self._rng)

    def move(self, instance: int, du: int) -> None:
        """Move a block to the right by so many pixels."""
        self.blocks = [
            replace(b, box=(b.box[0] + du, b.box[1], b.box[2] + du, b.box[3]))
            if b.instance == instance
            else b
            for b in self.blocks
        ]

    def look_into_basket(self, *, rgb: bool) -> Frame:
        """An empty basket, by an exact camera."""
        return paint([], rgb=rgb, camera=self._setup.basket_camera)
