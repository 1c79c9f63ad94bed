"""Small patches that lie within one thing each, and what can be counted of them and between them.

All counts add up: those of two patches taken together are the sum of both.
"""

from __future__ import annotations

from dataclasses import dataclass
from importlib import import_module
from typing import Any, cast

import numpy as np
from scipy import ndimage

from probe.errors import MissingExtra
from probe.perception.relief import Relief
from probe.types import Array

_STEP_MM, _BEND, _CONTRAST = 3.0, 0.6, 25.0
_BLUR = 0.7
_SHALLOW = 0.05


@dataclass(frozen=True, eq=False)
class Patches:
    """An over-segmentation.

    Attributes:
        numbers: Patch of each cell from 1 on, 0 for the table; int, shape (h, w).
        inside: What is counted of each patch, shape (n + 1, 8): cells, sums of L*, a*, b* and of
            their squares, cells of outline. Row 0 is the table's.
        pairs: Patches that meet, the lower number first, shape (m, 2).
        borders: What is counted of their common border, shape (m, 6): its length, and the sums
            of what `_along` lists.
    """

    numbers: Array
    inside: Array
    pairs: Array
    borders: Array


def patches(scene: Relief) -> Patches:
    """Cut a relief along its edges, watershed by watershed; some edges run through things.

    Raises:
        MissingExtra: scikit-image isn't installed.
    """
    numbers = _watershed(scene)
    inside = _inside(numbers, scene)
    return Patches(numbers, inside, *_borders(numbers, scene))


def _watershed(scene: Relief) -> Array:
    try:
        # Not imported above: it is installed on demand. It ships half of its types.
        morphology: Any = import_module("skimage.morphology")
        segmentation: Any = import_module("skimage.segmentation")
    except ImportError as error:
        raise MissingExtra("Segmenting pictures", "segment") from error
    edges = scene.step / _STEP_MM + scene.valley / _BEND + scene.contrast / _CONTRAST
    wall: Array = ndimage.gaussian_filter(1 - np.exp(-edges), _BLUR)
    basins = morphology.h_minima(wall, _SHALLOW).astype(bool) & scene.raised
    seeds, _ = cast("tuple[Array, int]", ndimage.label(basins))
    return segmentation.watershed(wall, seeds, mask=scene.raised)


def _inside(numbers: Array, scene: Relief) -> Array:
    count = int(numbers.max()) + 1
    flat = numbers.ravel()
    outline = np.zeros(count)
    for here, there in _neighbours(numbers):
        one, other = numbers[here], numbers[there]
        differ = one != other
        outline += np.bincount(one[differ], minlength=count)
        outline += np.bincount(other[differ], minlength=count)
    colours = scene.lab.reshape(-1, 3).T
    sums = [np.bincount(flat, channel, count) for channel in (*colours, *colours**2)]
    return np.column_stack([np.bincount(flat, minlength=count), *sums, outline])


def _neighbours(numbers: Array) -> tuple[tuple[tuple[slice, slice], tuple[slice, slice]], ...]:
    """Slices of all cells and of those below them, and to their right."""
    h, w = numbers.shape
    every = slice(None)
    down = ((slice(0, h - 1), every), (slice(1, h), every))
    return down, ((every, slice(0, w - 1)), (every, slice(1, w)))


def _borders(numbers: Array, scene: Relief) -> tuple[Array, Array]:
    size = int(numbers.max()) + 1
    keys: list[Array] = []
    values: list[Array] = []
    for (here, there), (down, across) in zip(_neighbours(numbers), ((1, 0), (0, 1)), strict=True):
        one, other = numbers[here], numbers[there]
        rows, columns = np.nonzero((one != other) & (one > 0) & (other > 0))
        ends = one[rows, columns], other[rows, columns]
        keys.append(np.minimum(*ends).astype(np.int64) * size + np.maximum(*ends))
        values.append(_along(scene, rows, columns, down, across))
    found, place = np.unique(np.concatenate(keys), return_inverse=True)
    every = np.concatenate(values)
    sums = [np.bincount(place, column, len(found)) for column in every.T]
    return np.column_stack([found // size, found % size]), np.column_stack(sums)


def _along(scene: Relief, rows: Array, columns: Array, down: int, across: int) -> Array:
    """One row a place where two patches meet.

    1; step up to 10 mm; whether it is over 1.5; valley; ridge; contrast.
    """
    beside = rows + down, columns + across

    def either(values: Array) -> Array:
        return np.maximum(values[rows, columns], values[beside])

    step = either(scene.step)
    return np.column_stack(
        [
            np.ones(len(rows)),
            np.minimum(step, 10),
            step > 1.5,
            np.minimum(either(scene.valley), 2),
            np.minimum(either(scene.ridge), 2),
            np.minimum(either(scene.contrast), 60),
        ]
    )
