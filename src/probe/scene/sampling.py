"""Draws what a scene holds and how each object starts to fall. Data only; physics decides later."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from probe.assets.spec import ObjectSpec
from probe.errors import Unsatisfiable
from probe.types import Quaternion

DEFAULT_COUNT = 15
"""Objects in a scene, where the question doesn't say otherwise."""

PILE_REACH = 0.17
"""Objects are dropped within this distance, along x and y, of the table's middle: a tight pile."""

_TUMBLED_SHARE = 0.4


@dataclass(frozen=True)
class Drop:
    """How one object starts to fall: its spot on the table (metres) and its orientation."""

    x: float
    y: float
    wxyz: Quaternion


def draw_objects(
    specs: Sequence[ObjectSpec], count: int, rng: np.random.Generator
) -> tuple[ObjectSpec, ...]:
    """Draw objects that a person could tell apart by name.

    No two share a short name, and two of one category differ in their main colour.

    Raises:
        Unsatisfiable: The library has no such set of this size.
    """
    drawn: list[ObjectSpec] = []
    taken: set[tuple[str, ...]] = set()
    order: list[int] = rng.permutation(len(specs)).tolist()
    for spec in (specs[index] for index in order):
        if len(drawn) == count:
            break
        marks: set[tuple[str, ...]] = {
            ("name", spec.name),
            ("look", spec.category, *spec.colours[:1]),
        }
        if taken.isdisjoint(marks):
            taken |= marks
            drawn.append(spec)
    if len(drawn) < count:
        raise Unsatisfiable(
            f"Only {len(drawn)} of {count} objects can be told apart by name among the "
            f"{len(specs)} of this library. Ask for fewer objects or add some to the library."
        )
    return tuple(drawn)


def draw_drop(rng: np.random.Generator, reach: float = PILE_REACH) -> Drop:
    """Draw a spot in the pile and an orientation: most stand as they would, some are tumbled."""
    x, y = (float(v) for v in rng.uniform(-reach, reach, size=2))
    if rng.random() < _TUMBLED_SHARE:
        w, a, b, c = (float(v) for v in _random_rotation(rng))
        return Drop(x, y, (w, a, b, c))
    half_turn = float(rng.uniform(0, math.pi))
    return Drop(x, y, (math.cos(half_turn), 0.0, 0.0, math.sin(half_turn)))


def _random_rotation(rng: np.random.Generator) -> np.ndarray:
    """A uniformly random unit quaternion: a normalised Gaussian in four dimensions."""
    wxyz = rng.normal(size=4)
    return wxyz / np.linalg.norm(wxyz)
