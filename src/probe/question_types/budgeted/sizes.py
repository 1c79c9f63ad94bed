"""Which covers a length rules out, and how a question tells that length."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

import numpy as np
from scipy.spatial import ConvexHull

from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.generation.covers import cover_of
from probe.generation.likeness import longest
from probe.types import Array, Pose

RULED_OUT = 1.15
"""What lies flat and is so many times as long as a cover is across would stick out beneath it."""


def told_length(candidates: Sequence[ObjectSpec]) -> str:
    """The length that a question tells, in centimetres, to half a centimetre.

    It is the middle of all the candidates' lengths, so that it is the same whichever is there.
    """
    sizes = [100 * longest(spec) for spec in candidates]
    return f"{round(min(sizes) + max(sizes)) / 2:g}"


def too_small(library: Library, object_id: str, shortest: float) -> bool:
    """Whether nothing of a length, metres, can lie flat beneath a cover and not stick out."""
    return RULED_OUT * across(library, object_id) <= shortest


@lru_cache(maxsize=512)
def across(library: Library, object_id: str) -> float:
    """The longest line across the outline of a thing that lies as a cover, from above, metres."""
    cover = cover_of(library, object_id)
    turned = Pose(wxyz=cover.wxyz) if cover else Pose()
    corners: Array = turned.apply(library.form(object_id).mesh.vertices)[:, :2]
    rim = corners[ConvexHull(corners).vertices]
    return float(np.linalg.norm(rim[:, None] - rim[None], axis=2).max())
