"""The colours of things, for Compare: of whole objects, and of what a picture shows of them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np

from probe.assets.cache import content_key
from probe.assets.colour.names import lab, nearest_colours
from probe.assets.library import Library
from probe.assets.mesh.lattice import colours_at, spots
from probe.assets.mesh.mesh import TexturedMesh
from probe.assets.recipes import recipe
from probe.types import Array

_SPOTS = 4000
_SMALLEST_SHARE = 0.08
_SECOND = 7 / 8
"""Most that a thing of one main colour has of its second one, by the main one's share: which of two
comes first would else depend on the side that is seen, and on the light."""

_BLACK = np.array([16.0, 0.0, 0.0])


@dataclass(frozen=True)
class ThingColour:
    """One colour of a thing.

    Attributes:
        lab: Mean CIELAB of the parts that have it.
        share: Of the surface, or of the pixels, 0 to 1.
    """

    lab: tuple[float, float, float]
    share: float


@lru_cache(maxsize=2048)
def palette_of(library: Library, object_id: str) -> tuple[ThingColour, ...]:
    """Colours of an object's surface, by its texture; measured once, then kept."""

    def measured() -> dict[str, Array]:
        return _measured(library.body(object_id).mesh)

    return _unpacked(library.measured(object_id, "palettes", _recipe(), measured))


@lru_cache(maxsize=1)
def _recipe() -> str:
    """A hash of all that decides an object's palette, except for its body."""
    code = recipe("probe.assets.colour"), recipe("probe.assets.mesh")
    return content_key(*code, Path(__file__).read_bytes())


def _measured(mesh: TexturedMesh) -> dict[str, Array]:
    palette = shades(colours_at(mesh, *spots(mesh.vertices, mesh.faces, _SPOTS)))
    return {
        "lab": np.array([colour.lab for colour in palette]),
        "shares": np.array([colour.share for colour in palette]),
    }


def _unpacked(stored: Mapping[str, Array]) -> tuple[ThingColour, ...]:
    colours = zip(stored["lab"].tolist(), stored["shares"].tolist(), strict=True)
    return tuple(ThingColour((lightness, a, b), share) for (lightness, a, b), share in colours)


def main_colour(library: Library, object_id: str) -> Array:
    """CIELAB of the colour that most of an object's surface has, shape (3,)."""
    return np.array(palette_of(library, object_id)[0].lab)


def has_one_main_colour(library: Library, object_id: str) -> bool:
    """Whether clearly more of an object's surface has its main colour than has any other."""
    first, *others = palette_of(library, object_id)
    return not others or others[0].share <= _SECOND * first.share


def dimmed(colours: Array, root: float) -> Array:
    """CIELAB of surfaces in less light, shape (..., 3).

    Args:
        colours: CIELAB in full light.
        root: Cube root of the share of the light that is left: what CIELAB's three functions of
            the light are multiplied by (CIE 15:2004, 8.2.1), but for very dark colours.
    """
    return (colours + _BLACK) * root - _BLACK


def shades(pixels: Array) -> tuple[ThingColour, ...]:
    """Colours of pixels, sRGB uint8, shape (n, 3), as everyday words tell them apart.

    The most frequent first; rare ones are left out.
    """
    sample = pixels[:: max(1, len(pixels) // _SPOTS)]
    names, values = nearest_colours(sample), lab(sample)
    found: list[ThingColour] = []
    for name in np.unique(names):
        mine = values[names == name]
        lightness, a, b = (float(value) for value in mine.mean(axis=0))
        found.append(ThingColour((lightness, a, b), len(mine) / len(sample)))
    found.sort(key=lambda shade: -shade.share)
    return tuple(shade for shade in found if shade.share >= _SMALLEST_SHARE or shade is found[0])
