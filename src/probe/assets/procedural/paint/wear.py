"""What use leaves on a surface: faded colours, grime at seams, smudges, scratches, relief."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.ndimage import gaussian_filter

from probe.assets.procedural.paint.canvas import Canvas, mix, shade, step
from probe.assets.procedural.paint.data import Paint
from probe.assets.procedural.paint.materials import Layers, Metal, Weave, Wood
from probe.assets.procedural.paint.prints import Print
from probe.types import Array

_LUMINANCE = np.array([0.2126, 0.7152, 0.0722], np.float32)
_FADED = 0.14
"""How far colours are drawn towards their own grey; pigments that are handled are never pure."""
_GRIME = np.array([0.20, 0.17, 0.13], np.float32)
_SOFT: dict[type[object], float] = {Weave: 0.5, Layers: 0.3, Wood: 0.5, Print: 0.7, Metal: 0.6}
"""How strongly smudges show on a material; 1 on paint, glaze and plastic."""
_RELIEF: dict[type[object], float] = {Weave: 7.0, Layers: 2.5, Wood: 1.6, Print: 0.5, Metal: 0.5}
"""How rough a material's relief is; 1 is moulded plastic."""


@dataclass(frozen=True, eq=False)
class Worn:
    """A surface after use, arrays of shape (h, w) or (h, w, 3).

    Attributes:
        colour: sRGB about 0 to 1.
        roughness: Factor on the thing's own.
        height: Relief in pixels.
    """

    colour: Array
    roughness: Array
    height: Array


def worn(picture: Array, paint: Paint, canvas: Canvas, rng: np.random.Generator) -> Worn:
    """A painted surface as it looks after use.

    Args:
        picture: As the paint drew it, sRGB about 0 to 1, shape (h, w, 3).
        paint: What drew it.
        canvas: The surface.
        rng: Source of all marks.
    """
    grey = (picture @ _LUMINANCE)[..., None]
    colour = picture + _FADED * (grey - picture)
    broad, middle = canvas.noise(rng, 0.045, octaves=2), canvas.noise(rng, 0.009, octaves=3)
    colour = shade(colour, 0.045 * broad + 0.025 * middle)
    dirt = _seams(canvas) * (0.6 + 0.5 * middle) + 0.25 * step(broad + middle, 0.9, 2.2)
    colour = mix(colour, _GRIME, np.clip(0.30 * dirt, 0, 0.45).astype(np.float32))
    smudged = _SOFT.get(type(paint), 1.0)
    scratched = step(canvas.noise(rng, 0.0009, (14, 1.2, 1.2)), 1.5, 2.2)
    roughness = 1 + smudged * (0.30 * step(middle, -0.2, 1.2) - 0.12 + 0.25 * scratched)
    colour = shade(colour, 0.05 * smudged * scratched)
    return Worn(colour, roughness, _relief(picture, paint, canvas, rng))


def _seams(canvas: Canvas) -> Array:
    """1 at the rims of a surface, where it meets the next, falling off within millimetres.

    What is wrapped around closes on itself, and a pole is no rim.
    """
    points, x, y = canvas.sheet.points, canvas.across(), canvas.down()
    edges = [y if _long(points[0]) else None, y[::-1] if _long(points[-1]) else None]
    if _long(points[:, 0] - points[:, -1], spread=False):
        edges += [x, x[:, ::-1]]
    near = np.zeros(canvas.shape, np.float32)
    for edge in edges:
        if edge is not None:
            near = np.maximum(near, np.exp(-edge / 0.0016))
    return near


def _long(points: Array, *, spread: bool = True) -> bool:
    """Whether a row of points leads anywhere, or a row of vectors isn't nothing; over 1 mm."""
    return float((np.ptp(points, axis=0) if spread else np.abs(points)).max()) > 0.001


def _relief(picture: Array, paint: Paint, canvas: Canvas, rng: np.random.Generator) -> Array:
    """Height in pixels: fine grain, and threads and fibres where the picture shows them."""
    strength = _RELIEF.get(type(paint), 1.0)
    fine: Array = gaussian_filter(rng.standard_normal(canvas.shape, dtype=np.float32), 1.6) * 4
    height = 0.05 * fine
    if isinstance(paint, Weave | Layers | Wood):
        threads: Array = gaussian_filter(picture @ _LUMINANCE, 0.7)
        height = height + 0.25 * threads
    return np.asarray(strength * height, np.float32)
