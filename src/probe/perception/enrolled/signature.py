"""What a thing looks like from one side: its colours, its size and its outline. Knows no names."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from probe.perception.enrolled.colours import colours_of
from probe.perception.outline import shape_word
from probe.types import Array, Frame

_MIDDLE = (2, 98)
"""Percentiles between which a size is taken, so that a few stray readings don't stretch it."""


@dataclass(frozen=True, eq=False)
class Signature:
    """What shows of a thing.

    Attributes:
        colours: Histogram in CIELAB that adds up to 1; see colours_of().
        area: Of what shows, seen along the camera's rays, square metres.
        length, width: Extents over the table, along the longer side and across it, metres.
        height: How far what shows reaches from its lowest to its highest point, metres.
        outline: One or two words; see shape_word().
    """

    colours: Array
    area: float
    length: float
    width: float
    height: float
    outline: str


def signature_of(frame: Frame, mask: Array) -> Signature:
    """The signature of what a mask shows.

    Args:
        frame: With colours.
        mask: bool, shape (h, w), not empty.
    """
    assert frame.rgb is not None
    rows, columns = np.nonzero(mask)
    depth = frame.depth[rows, columns].astype(float)
    points = frame.camera.lift(np.column_stack([columns, rows]) + 0.5, depth)
    length, width = _extents(points[:, :2])
    low, high = np.percentile(points[:, 2], _MIDDLE)
    return Signature(
        colours_of(frame.rgb[mask]),
        float(np.sum((depth / frame.camera.focal_px) ** 2)),
        length,
        width,
        float(high - low),
        shape_word(mask, points[:, 2]),
    )


def _extents(places: Array) -> tuple[float, float]:
    """Longer and shorter side of the principal box around points on the table, shape (n, 2)."""
    centred = places - places.mean(axis=0)
    _, axes = np.linalg.eigh(centred.T @ centred)
    low, high = np.percentile(centred @ axes, _MIDDLE, axis=0)
    short, long = np.sort(high - low)
    return float(long), float(short)
