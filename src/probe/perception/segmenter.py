"""Things in a colour and depth picture without any model: no labels, no names.

It takes the table to be flat and at z = 0, and things to differ from their neighbours by a step,
a crease or a colour. What an object hides the middle of comes out as two things.
"""

from __future__ import annotations

from typing import Protocol

import numpy as np

from probe.perception.looks import look_of
from probe.perception.merging import merged
from probe.perception.patches import patches
from probe.perception.relief import relief
from probe.perception.sameness import sameness
from probe.perception.things import Thing, Words
from probe.types import Array, Frame

ENOUGH = 0.5
"""Probability from which on two patches are joined."""

SMALLEST_PX = 200
"""Pixels from which on a patch is a thing."""

NEAR_PX = 8
"""A point on the table this close to a thing still means it."""


class Masker(Protocol):
    """Says what lies under a pixel."""

    def mask_at(self, frame: Frame, point_px: tuple[int, int]) -> Array | None:
        """Visible pixels of the thing at (u, v), bool, shape (h, w); None if nothing is there."""
        ...


class Segmenter:
    """Masks from colours and depth; a Detector and a Masker. Labels aren't looked at."""

    def __init__(self, enough: float = ENOUGH) -> None:
        """Enough: probability from which on two patches are joined, 0 to 1."""
        self._enough = enough
        self._last: tuple[Frame, Array] | None = None

    def needs_rgb(self, frame: Frame) -> bool:
        """Always: things are told apart by their colours too."""
        return True

    def detect(self, frame: Frame) -> tuple[Thing, ...]:
        """Everything on the table, told by its looks, sorted by point from the top.

        Raises:
            MissingExtra: scikit-image isn't installed.
        """
        numbers = self.numbers(frame)
        sizes = np.bincount(numbers.ravel())
        found = [
            thing_of(numbers == number, frame)
            for number in range(1, len(sizes))
            if sizes[number] >= SMALLEST_PX
        ]
        return tuple(sorted(found, key=lambda thing: thing.point_px[::-1]))

    def mask_at(self, frame: Frame, point_px: tuple[int, int]) -> Array | None:
        """Visible pixels of the thing at (u, v), bool, shape (h, w); None on the bare table."""
        numbers = self.numbers(frame)
        u, v = point_px
        top, left = max(v - NEAR_PX, 0), max(u - NEAR_PX, 0)
        around = numbers[top : v + NEAR_PX + 1, left : u + NEAR_PX + 1]
        rows, columns = np.nonzero(around)
        if len(rows) == 0:
            return None
        nearest = np.hypot(rows + top - v, columns + left - u).argmin()
        return numbers == around[rows[nearest], columns[nearest]]

    def numbers(self, frame: Frame) -> Array:
        """Which thing each pixel shows, from 1 on, 0 for the table; int, shape (h, w)."""
        if self._last is None or self._last[0] is not frame:
            scene = relief(frame)
            cells = merged(patches(scene), sameness, self._enough)
            pixels = np.repeat(np.repeat(cells, scene.stride, axis=0), scene.stride, axis=1)
            h, w = frame.depth.shape
            self._last = frame, pixels[:h, :w]
        return self._last[1]


def thing_of(mask: Array, frame: Frame) -> Thing:
    """A thing that is told by its looks alone; the frame must have colours."""
    colours, look = look_of(mask, frame)
    return Thing.of(mask, Words(None, "", colours, look))
