"""Draws what a scene holds and how each object starts to fall. Data only; physics decides later."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from probe.assets.spec import ObjectSpec
from probe.errors import Unsatisfiable
from probe.scene.setup import Setup
from probe.scene.turns import Leads, in_turn, nobody
from probe.types import Quaternion

DEFAULT_COUNT = 15
"""Objects in a scene, where the question doesn't say otherwise."""

_TUMBLED_SHARE = 0.4
_OVER = 0.01


@dataclass(frozen=True)
class PileSettings:
    """How tight a pile is, and how much of it lies under something.

    Attributes:
        reach: Objects are dropped within this distance, along x and y, of the table's middle,
            metres; at most half of the work area.
        buried: So many of the smallest are put down first, each with a larger one dropped right
            over it.
    """

    reach: float = 0.17
    buried: int = 0

    def __post_init__(self) -> None:
        """Refuse what can't be dropped.

        Raises:
            Unsatisfiable: Less than nothing is buried.
        """
        if self.buried < 0:
            raise Unsatisfiable(f"At least 0 objects can be buried, not {self.buried}.")

    def check_reach(self, setup: Setup) -> None:
        """Refuse what a set-up has no room for.

        Raises:
            Unsatisfiable: The reach leaves the work area.
        """
        most = setup.work_area / 2
        if not 0.0 < self.reach <= most:
            raise Unsatisfiable(
                f"A pile's reach is above 0 and at most {most} m, not {self.reach}."
            )


TIGHT = PileSettings()


@dataclass(frozen=True)
class Drop:
    """How one object starts to fall: its spot on the table (metres) and its orientation."""

    x: float
    y: float
    wxyz: Quaternion


def draw_objects(
    specs: Sequence[ObjectSpec], count: int, rng: np.random.Generator, leads: Leads = nobody
) -> tuple[ObjectSpec, ...]:
    """Draw objects that a person could tell apart by name, those that lead before all others.

    No two share a short name, and two of one category differ in their main colour.

    Raises:
        Unsatisfiable: The library has no such set of this size.
    """
    drawn: list[ObjectSpec] = []
    taken: set[tuple[str, ...]] = set()
    for spec in in_turn(specs, leads, rng):
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


def draw_drop(rng: np.random.Generator, reach: float = TIGHT.reach) -> Drop:
    """Draw a spot in the pile and an orientation: most stand as they would, some are tumbled."""
    x, y = (float(v) for v in rng.uniform(-reach, reach, size=2))
    if rng.random() < _TUMBLED_SHARE:
        w, a, b, c = (float(v) for v in _random_rotation(rng))
        return Drop(x, y, (w, a, b, c))
    half_turn = float(rng.uniform(0, math.pi))
    return Drop(x, y, (math.cos(half_turn), 0.0, 0.0, math.sin(half_turn)))


def draw_pile(
    specs: Sequence[ObjectSpec], pile: PileSettings, rng: np.random.Generator
) -> tuple[tuple[int, Drop], ...]:
    """Draw in which order objects are dropped, and how each starts to fall.

    Args:
        specs: The objects.
        pile: How tight.
        rng: Draws spots and orientations.

    Returns:
        Index and drop of each, in order: those to be buried, what buries them, then the rest, the
        largest first.
    """
    order = sorted(range(len(specs)), key=lambda index: -math.prod(specs[index].size))
    count = min(pile.buried, len(order) // 2)
    drops = [draw_drop(rng, pile.reach) for _ in specs]
    wide = sorted(order[: len(order) - count], key=lambda index: -_footprint(specs[index]))
    pairs: list[tuple[int, Drop]] = []
    for small, large in zip(order[len(order) - count :], wide, strict=False):
        spot = drops[small]
        pairs += [(small, spot), (large, _laid_over(specs[large], spot, rng))]
    paired = {index for index, _ in pairs}
    return (*pairs, *((index, drops[index]) for index in order if index not in paired))


def _footprint(spec: ObjectSpec) -> float:
    """Area that a thing covers when it lies on its broadest side."""
    return math.prod(sorted(spec.size)[1:])


def _laid_over(spec: ObjectSpec, spot: Drop, rng: np.random.Generator) -> Drop:
    """Lying on its broadest side, its middle within a centimetre of a spot."""
    x, y = (float(v) for v in rng.uniform(-_OVER, _OVER, size=2))
    half_turn = float(rng.uniform(0, math.pi))
    c, s = math.cos(half_turn), math.sin(half_turn)
    thin = int(np.argmin(spec.size))
    if thin == 2:
        return Drop(spot.x + x, spot.y + y, (c, 0.0, 0.0, s))
    # A quarter turn about the other level axis stands the thin side up; then the turn about z.
    h = math.sqrt(0.5)
    if thin == 1:
        return Drop(spot.x + x, spot.y + y, (h * c, h * c, h * s, h * s))
    return Drop(spot.x + x, spot.y + y, (h * c, -h * s, h * c, h * s))


def _random_rotation(rng: np.random.Generator) -> np.ndarray:
    """A uniformly random unit quaternion: a normalised Gaussian in four dimensions."""
    wxyz = rng.normal(size=4)
    return wxyz / np.linalg.norm(wxyz)
