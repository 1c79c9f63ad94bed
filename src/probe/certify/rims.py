"""Colours of the rims of things: what shows where one peeks out from under its cover."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from probe.assets.colour_difference import ciede2000
from probe.assets.library import Library
from probe.assets.sampling import colours_at, places, spots, topmost
from probe.assets.spec import ObjectSpec
from probe.certify.covers import lies_on_side, on_side
from probe.certify.palettes import dimmed, main_colour, shades
from probe.types import Array, Pose

CLEAR = 0.6
"""Share of what shows from which on its main colour is the same in any light."""

_SPOTS = 6000
_DIRECTIONS = 12
_OUTER = 0.2
_CELLS = 40
_SKIN = 0.1

NEAR = 10.0
"""CIEDE2000 up to which a patch is what was planned."""

_SAME = 5.0
"""CIEDE2000 up to which one patch can stand for another: about what light does to one and the same
patch in pictures (standard deviation of L* 4.7, a* 2.4, b* 1.9, 600 patches). Up to 10, nearest
neighbours could tell the two apart in 61 % of 800 drawn stories; up to 5 in 52 %."""

_ODD = 15.0
"""CIEDE2000 from which a side isn't of its thing's main colour."""

_BESIDE_COVERS = 0.80
"""Cube root of the light that covers leave of a texture's in pictures: median of 17 patches."""


@dataclass(frozen=True, eq=False)
class Rims:
    """All sides of some things, as pictures show them in a cover's shade.

    Attributes:
        specs: The things; each has at least one side.
        main: Their main colours by texture, CIELAB, shape (k, 3).
        owner: Whose side it is, as a place in `specs`, shape (n,).
        angles: Where on its thing the side is, radians, shape (n,); see Side.
        colours: Of the sides, CIELAB, shape (n, 3).
    """

    specs: tuple[ObjectSpec, ...]
    main: Array
    owner: Array
    angles: Array
    colours: Array

    @staticmethod
    def of(library: Library, specs: Iterable[ObjectSpec]) -> Rims:
        """Those of some of a library's things; who has no clear side is left out."""
        found = {spec: rims for spec in specs if (rims := sides(library, spec.id))}
        return Rims(
            tuple(found),
            np.array([main_colour(library, spec.id) for spec in found]).reshape(-1, 3),
            np.repeat(np.arange(len(found)), [len(rims) for rims in found.values()]),
            np.array([side.angle for rims in found.values() for side in rims]),
            in_shade(
                np.array([side.lab for rims in found.values() for side in rims]).reshape(-1, 3)
            ),
        )

    def odd(self) -> Array:
        """Places of things with a side that isn't of their main colour, shape (m,)."""
        apart = ciede2000(in_shade(self.main)[self.owner], self.colours)
        return np.unique(self.owner[apart >= _ODD])

    def showing(self, colour: Array) -> Array:
        """Places of things of which some side is near a colour, shape (m,)."""
        return np.unique(self.owner[ciede2000(self.colours, colour) <= _SAME])

    def facing(self, place: int, colour: Array) -> Array:
        """Angles of those of a thing's sides that are near a colour, radians, shape (m,)."""
        mine = self.owner == place
        return self.angles[mine][ciede2000(self.colours[mine], colour) <= _SAME]


def in_shade(texture: Array) -> Array:
    """What a picture shows of textures beside covers, CIELAB, shape (..., 3)."""
    return dimmed(texture, _BESIDE_COVERS)


@dataclass(frozen=True)
class Side:
    """One side of a thing.

    Attributes:
        angle: Which way it faces on a thing that isn't turned about the vertical, radians from x.
        lab: Clear main colour of the outermost fifth there, seen from above, CIELAB.
    """

    angle: float
    lab: tuple[float, float, float]


@lru_cache(maxsize=2048)
def sides(library: Library, object_id: str) -> tuple[Side, ...]:
    """Sides of a thing that lies as it is laid beneath a cover; those of many colours left out."""
    mesh = library.body(object_id).mesh
    face, weights = spots(mesh.vertices, mesh.faces, _SPOTS)
    points = places(mesh.vertices, mesh.faces, face, weights)
    if lies_on_side(spec := library[object_id]):
        points = Pose(wxyz=on_side(spec)).apply(points)
    colours = colours_at(mesh, face, weights)
    top = _from_above(points)
    found = list[Side]()
    for angle in np.arange(_DIRECTIONS) * 2 * math.pi / _DIRECTIONS:
        out = points[:, :2] @ np.array([np.cos(angle), np.sin(angle)])
        outer = top & (out >= np.quantile(out[top], 1 - _OUTER))
        shade = shades(colours[outer])[0]
        if shade.share >= CLEAR:
            found.append(Side(float(angle), shade.lab))
    return tuple(found)


def _from_above(points: Array) -> Array:
    """Which points, shape (n, 3), have none of the others far above them."""
    low, high = points.min(axis=0), points.max(axis=0)
    cells = ((points[:, :2] - low[:2]) / (high - low)[:2].max() * (_CELLS - 1)).astype(int)
    cell = cells[:, 0] * _CELLS + cells[:, 1]
    return topmost(cell, points[:, 2], _CELLS * _CELLS, _SKIN * (high - low)[2])
