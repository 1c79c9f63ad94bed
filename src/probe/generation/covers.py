"""What can hide something beneath it, and how it then lies. Geometry of single objects."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.generation.cover_shape import packed, shape_of, shape_recipe, unpacked
from probe.scene.turns import in_turn
from probe.types import Array, Quaternion

GRASP_WIDTH = 0.125
"""Metres; a deep cover wider than this can't be lifted by a 2F-140, and pushed drags its secret."""

FLAT_WIDTH = 0.22
FLAT_THICKNESS = 0.05
"""Metres; what is thin can be lifted by an edge or pushed off."""

SLAB_THICKNESS = 0.04
SMALLEST_SLAB = 0.085, 0.13
TOPPING = 0.05, 0.10
_TOPPING_SHARE, _TOPPING_FLATNESS = 0.65, 0.6
SMALLEST_COVER = 0.07
_WIDER = 1.2
_STEEPER = 1.3
_MOST, _WIDEST_SHIELD = 0.75, 0.19
_TALLER = 1.2
"""A cover may stand on what it hides and still hide it, up to this."""

_LOWER = 0.3
"""Highest thing, by the width of a flat cover, that it doesn't slide off."""

NEEDS_COVER = (
    f"a hollow thing {100 * SMALLEST_COVER:g} to {100 * GRASP_WIDTH:g} cm wide, or a flat one "
    f"{100 * SMALLEST_COVER:g} to {100 * FLAT_WIDTH:g} cm wide and at most "
    f"{100 * FLAT_THICKNESS:g} cm thick, {_WIDER:g} times as wide as what it hides"
)
NEEDS_LEAN = (
    f"a flat thing {100 * SMALLEST_COVER:g} to {100 * FLAT_WIDTH:g} cm wide, at most "
    f"{100 * FLAT_THICKNESS:g} cm thick and at least as wide as what it hides"
)
NEEDS_SLAB = (
    f"{100 * SMALLEST_SLAB[0]:g} to {100 * GRASP_WIDTH:g} cm wide, "
    f"{100 * SMALLEST_SLAB[1]:g} to {100 * FLAT_WIDTH:g} cm long and at most "
    f"{100 * SLAB_THICKNESS:g} cm thick"
)
NEEDS_SHIELD = (
    f"flat things {100 * SMALLEST_COVER:g} cm wide or more, up to {100 * _WIDEST_SHIELD:g} cm long "
    f"and at most {100 * FLAT_THICKNESS:g} cm thick"
)
"""What draw_cover(), draw_lean(), draw_slab() and draw_shield() look for, for people."""


@dataclass(frozen=True)
class Footprint:
    """Room that an object needs in its resting pose, metres.

    Attributes:
        width: Diameter of the circle around its middle that it fills.
        height: Its height.
    """

    width: float
    height: float


@dataclass(frozen=True)
class Cover:
    """An object lying so that it covers what is beneath.

    Attributes:
        spec: Which object.
        wxyz: Its orientation as a cover, before any turn about the vertical.
        extent: Size along x, y, z in that orientation, metres.
        middle: Where its cavity's middle is, (x, y) from the middle of its extent.
        width: Of its cavity; 0 for flat things.
        depth: Of its cavity; 0 for flat things.
        closed: Whether a flat thing has no hole near its middle that shows what lies beneath.
    """

    spec: ObjectSpec
    wxyz: Quaternion
    extent: tuple[float, float, float]
    middle: tuple[float, float]
    width: float
    depth: float
    closed: bool = True

    @property
    def reach(self) -> float:
        """Radius on the table around the middle of its extent, metres."""
        return max(self.extent[:2]) / 2

    def hides(self, item: Footprint) -> bool:
        """Whether it may hide something, over it or, if that is low, laid on top of it."""
        if self.depth > 0:
            return self.width >= item.width and _TALLER * self.depth >= item.height
        return _overhangs(min(self.extent[:2]), item)


def draw_cover(
    library: Library,
    specs: Sequence[ObjectSpec],
    items: Sequence[Footprint],
    rng: np.random.Generator,
) -> Cover | None:
    """Draw a cover that may hide each of these; None if there is none."""
    for spec in in_turn(specs, library.leads, rng):
        if all(_may_cover(spec, item) for item in items):
            cover = cover_of(library, spec.id)
            if cover and all(cover.hides(item) for item in items):
                return cover
    return None


def draw_lean(
    library: Library,
    specs: Sequence[ObjectSpec],
    items: Sequence[Footprint],
    rng: np.random.Generator,
) -> Cover | None:
    """Draw a flat thing that, leaning on any of these, may leave a part in view, or None."""

    def leans(spec: ObjectSpec) -> bool:
        narrow = sorted(spec.size)[1]
        wide = all(narrow >= max(i.width, _STEEPER * i.height) for i in items)
        return _is_flat(spec) and wide

    return _draw_flat(library, specs, leans, rng)


def draw_slab(
    library: Library,
    specs: Sequence[ObjectSpec],
    items: Sequence[Footprint],
    rng: np.random.Generator,
) -> Cover | None:
    """Draw a flat thing that can be grasped and hides each of these, laid on top; or None."""

    def hides(spec: ObjectSpec) -> bool:
        thin, narrow, long = sorted(spec.size)
        slab = thin <= SLAB_THICKNESS and SMALLEST_SLAB[0] <= narrow <= GRASP_WIDTH
        slab = slab and SMALLEST_SLAB[1] <= long <= FLAT_WIDTH
        return slab and all(_overhangs(narrow, item) for item in items)

    return _draw_flat(library, specs, hides, rng)


def draw_shield(
    library: Library,
    specs: Sequence[ObjectSpec],
    items: Sequence[Footprint],
    rng: np.random.Generator,
    *,
    closed: bool = False,
) -> Cover | None:
    """Draw a flat thing that rests on any of these and hides most of it; None without one.

    Args:
        library: Has them.
        specs: To choose from.
        items: What is to be covered.
        rng: Draws.
        closed: Whether rings and the like won't do.
    """

    def rests(spec: ObjectSpec) -> bool:
        narrow = sorted(spec.size)[1]
        small = _is_flat(spec) and max(spec.size) <= _WIDEST_SHIELD
        return small and all(narrow >= max(_MOST * i.width, i.height / _LOWER) for i in items)

    return _draw_flat(library, specs, rests, rng, closed=closed)


def _draw_flat(
    library: Library,
    specs: Sequence[ObjectSpec],
    suits: Callable[[ObjectSpec], bool],
    rng: np.random.Generator,
    *,
    closed: bool = False,
) -> Cover | None:
    """Draw something of a suitable size that lies flat as a cover; None if there is none."""
    for spec in in_turn(specs, library.leads, rng):
        if suits(spec):
            cover = cover_of(library, spec.id)
            if cover and cover.depth == 0 and (cover.closed or not closed):
                return cover
    return None


def draw_topping(
    library: Library,
    specs: Sequence[ObjectSpec],
    items: Sequence[Footprint],
    rng: np.random.Generator,
) -> Cover | None:
    """Draw something small that can be grasped and stays where it is laid; None if there is none.

    The items don't matter: it only lies on top of what hides them.
    """
    for spec in in_turn(specs, library.leads, rng):
        if _lies_still(spec):
            return Cover(spec, (1.0, 0.0, 0.0, 0.0), spec.size, (0.0, 0.0), 0.0, 0.0)
    return None


def can_top(spec: ObjectSpec, cover: Cover) -> bool:
    """Whether something stays where it is laid on a cover and leaves much of it in view."""
    flat = spec.size[2] <= _TOPPING_FLATNESS * min(spec.size[:2])
    return flat and _lies_still(spec) and max(spec.size) <= _TOPPING_SHARE * min(cover.extent[:2])


def _lies_still(spec: ObjectSpec) -> bool:
    """Whether something is small and flat, and can be grasped."""
    x, y, z = spec.size
    return z <= min(x, y) <= GRASP_WIDTH and TOPPING[0] <= max(x, y) <= TOPPING[1]


def lies_on_side(spec: ObjectSpec) -> bool:
    """Whether something is laid on its side to be partly covered: what it bears slides off else."""
    x, y, z = spec.size
    return z > min(x, y)


def on_side(spec: ObjectSpec) -> Quaternion:
    """The turn that lays something on its longer side."""
    half = math.sqrt(0.5)
    return (half, 0.0, half, 0.0) if spec.size[0] < spec.size[1] else (half, half, 0.0, 0.0)


def low_footprint_of(library: Library, object_id: str) -> Footprint:
    """The footprint of an object that lies on its side if it would else be tall."""
    spec = library[object_id]
    x, y, _ = spec.size
    standing = footprint_of(library, object_id)
    return Footprint(max(spec.size), min(x, y)) if lies_on_side(spec) else standing


@lru_cache(maxsize=4096)
def footprint_of(library: Library, object_id: str) -> Footprint:
    """The footprint of an object, measured on its mesh once, then kept."""

    def measured() -> dict[str, Array]:
        x, y, _ = library.form(object_id).mesh.vertices.T
        return {"width": np.array(2 * float(np.hypot(x, y).max()))}

    size = library[object_id].size
    width = library.measured(object_id, "footprints", f"width 1, {size}", measured)["width"]
    return Footprint(float(width), size[2])


def _may_cover(spec: ObjectSpec, item: Footprint) -> bool:
    """Whether its size allows it to cover something; cheap, and without its mesh."""
    narrow = min(spec.size[:2])
    deep = spec.hollow and SMALLEST_COVER <= narrow <= GRASP_WIDTH
    encloses = deep and narrow >= item.width and _TALLER * spec.size[2] >= item.height
    return encloses or (_is_flat(spec) and _overhangs(sorted(spec.size)[1], item))


def _is_flat(spec: ObjectSpec) -> bool:
    thin, middle, _ = sorted(spec.size)
    return thin <= FLAT_THICKNESS and SMALLEST_COVER <= middle <= FLAT_WIDTH


def _overhangs(width: float, item: Footprint) -> bool:
    """Whether a flat thing of this width stays on top of something and hides it."""
    return width >= _WIDER * item.width and item.height <= _LOWER * width


@lru_cache(maxsize=512)
def cover_of(library: Library, object_id: str) -> Cover | None:
    """How an object lies as a cover; None if it is of no use as one. Measured once, then kept.

    A hollow one lies with its mouth down, a flat one on its largest side.
    """
    spec = library[object_id]

    def measured() -> dict[str, Array]:
        return packed(shape_of(spec, library.form(object_id).mesh))

    shape = unpacked(library.measured(object_id, "covers", shape_recipe(spec), measured))
    if shape is None:
        return None
    w, a, b, c, x, y, z, off_x, off_y, width, depth = shape.numbers
    return Cover(spec, (w, a, b, c), (x, y, z), (off_x, off_y), width, depth, shape.closed)
