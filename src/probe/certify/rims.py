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
"""CIEDE2000 up to which one patch could stand for another."""

_OFTEN = 0.2
"""Share of its sides on which a thing must show a colour to be asked to."""

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
        colours: Of the sides, CIELAB, shape (n, 3).
    """

    specs: tuple[ObjectSpec, ...]
    main: Array
    owner: Array
    colours: Array

    @staticmethod
    def of(library: Library, specs: Iterable[ObjectSpec]) -> Rims:
        """Those of some of a library's things; who has no clear side is left out."""
        found = {spec: rims for spec in specs if (rims := rim_colours(library, spec.id))}
        return Rims(
            tuple(found),
            np.array([main_colour(library, spec.id) for spec in found]).reshape(-1, 3),
            np.repeat(np.arange(len(found)), [len(rims) for rims in found.values()]),
            in_shade(np.array([lab for rims in found.values() for lab in rims]).reshape(-1, 3)),
        )

    def odd(self) -> Array:
        """Places of things with a side that isn't of their main colour, shape (m,)."""
        apart = ciede2000(in_shade(self.main)[self.owner], self.colours)
        return np.unique(self.owner[apart >= _ODD])

    def showing(self, colour: Array) -> Array:
        """Places of things that often enough show something near a colour, shape (m,)."""
        near = ciede2000(self.colours, colour) <= NEAR
        sides = np.bincount(self.owner, minlength=len(self.specs))
        shares = np.bincount(self.owner, near, minlength=len(self.specs)) / sides
        return np.flatnonzero(shares >= _OFTEN)


def in_shade(texture: Array) -> Array:
    """What a picture shows of textures beside covers, CIELAB, shape (..., 3)."""
    return dimmed(texture, _BESIDE_COVERS)


@lru_cache(maxsize=2048)
def rim_colours(library: Library, object_id: str) -> tuple[tuple[float, float, float], ...]:
    """Clear main colours of a thing's outermost fifth, seen from above, on each of its sides.

    It lies as it is laid beneath a cover. CIELAB; sides of many colours are left out.
    """
    mesh = library.body(object_id).mesh
    face, weights = spots(mesh.vertices, mesh.faces, _SPOTS)
    points = places(mesh.vertices, mesh.faces, face, weights)
    if lies_on_side(spec := library[object_id]):
        points = Pose(wxyz=on_side(spec)).apply(points)
    colours = colours_at(mesh, face, weights)
    top = _from_above(points)
    found = list[tuple[float, float, float]]()
    for turn in np.arange(_DIRECTIONS) * 2 * math.pi / _DIRECTIONS:
        out = points[:, :2] @ np.array([np.cos(turn), np.sin(turn)])
        outer = top & (out >= np.quantile(out[top], 1 - _OUTER))
        shade = shades(colours[outer])[0]
        if shade.share >= CLEAR:
            found.append(shade.lab)
    return tuple(found)


def _from_above(points: Array) -> Array:
    """Which points, shape (n, 3), have none of the others far above them."""
    low, high = points.min(axis=0), points.max(axis=0)
    cells = ((points[:, :2] - low[:2]) / (high - low)[:2].max() * (_CELLS - 1)).astype(int)
    cell = cells[:, 0] * _CELLS + cells[:, 1]
    return topmost(cell, points[:, 2], _CELLS * _CELLS, _SKIN * (high - low)[2])
