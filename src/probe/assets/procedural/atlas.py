"""One mesh with one texture from many surfaces with a paint each. Knows no shapes."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from probe.assets.mesh.mesh import Material, TexturedMesh, unpainted
from probe.assets.procedural.form.sheet import Sheet
from probe.assets.procedural.paint.canvas import Canvas
from probe.assets.procedural.paint.data import Paint
from probe.assets.procedural.paint.refined import refined
from probe.assets.procedural.paint.wear import worn
from probe.assets.tabletops.noise import normals_of
from probe.types import Array

SIDE_PX = 1024
GUTTER_PX = 4  # around each picture, so that blurred copies of the texture don't bleed
FINEST = 6000.0  # pixels a metre; more is never seen


def paint(
    sheets: Sequence[tuple[Sheet, Paint]],
    roughness: float,
    metallic: float,
    rng: np.random.Generator,
    wear: np.random.Generator | None = None,
    side_px: int = SIDE_PX,
) -> TexturedMesh:
    """Paint each surface and join all into one mesh, in their order.

    Args:
        sheets: Surfaces and what each is painted with.
        roughness: Of the material; with wear, its mean.
        metallic: Of the material.
        rng: Source of what paints scatter.
        wear: Source of the traces of use; None for a thing that looks new, without relief.
        side_px: Width and height of the texture.
    """
    extents = np.array([sheet.extent for sheet, _ in sheets])
    density, corners = _packed(extents, side_px)
    texture = np.full((side_px, side_px, 3), 128, dtype=np.uint8)
    rough = np.full((side_px, side_px), _byte(roughness), dtype=np.uint8)
    normal = np.full((side_px, side_px, 3), (128, 128, 255), dtype=np.uint8)
    uvs: list[Array] = []
    for (sheet, look), (x, y) in zip(sheets, corners, strict=True):
        width, height = _pixels(np.array(sheet.extent), density)
        canvas = Canvas(sheet, int(width), int(height), density)
        if wear is None:
            _put(texture, _byte(look.draw(canvas, rng)), x, y)
        else:
            look = refined(look)
            used = worn(look.draw(canvas, rng), look, canvas, wear)
            _put(texture, _byte(used.colour), x, y)
            _put(rough, _byte(np.maximum(roughness * used.roughness, 0.05)), x, y)
            _put(normal, normals_of(used.height, 1.0), x, y)
        offset = np.array([x, y]) + GUTTER_PX
        uvs.append((offset + sheet.uvs.reshape(-1, 2) * [width, height]) / side_px)
    maps = () if wear is None else (normal, rough)
    surface = Material(texture, roughness, metallic, *maps)
    whole = joined([sheet for sheet, _ in sheets])
    return replace(whole, uvs=np.vstack(uvs).astype(np.float32), surface=surface)


def _byte(values: Array | float) -> Array:
    """0 to 1 as 0 to 255."""
    return (np.clip(values, 0, 1) * 255 + 0.5).astype(np.uint8)


def _put(whole: Array, picture: Array, x: int, y: int) -> None:
    """Put a picture into its frame, with its rim repeated around it; in place."""
    rims = ((GUTTER_PX,) * 2, (GUTTER_PX,) * 2, (0, 0))[: picture.ndim]
    framed = np.pad(picture, rims, mode="edge")
    whole[y : y + framed.shape[0], x : x + framed.shape[1]] = framed


def joined(sheets: Sequence[Sheet]) -> TexturedMesh:
    """All surfaces in one mesh, in their order, in plain grey."""
    starts = np.cumsum([0, *(sheet.points[..., 0].size for sheet in sheets)])
    faces = [sheet.faces + start for sheet, start in zip(sheets, starts[:-1], strict=True)]
    return unpainted(
        vertices=np.vstack([s.points.reshape(-1, 3) for s in sheets]).astype(np.float32),
        normals=np.vstack([s.normals.reshape(-1, 3) for s in sheets]).astype(np.float32),
        faces=np.vstack(faces).astype(np.int32),
    )


def _pixels(extent: Array, density: float) -> Array:
    return np.maximum(8, np.round(extent * density)).astype(int)


def _packed(extents: Array, side_px: int) -> tuple[float, list[tuple[int, int]]]:
    """The finest density at which all pictures fit, and the corner of each one's frame."""
    low, high = 200.0, FINEST
    best = _shelved(extents, low, side_px)
    for _ in range(14):
        middle = (low + high) / 2
        corners = _shelved(extents, middle, side_px)
        if corners is None:
            high = middle
        else:
            low, best = middle, corners
    if best is None:
        raise ValueError("surfaces too large for one texture; give the shape fewer or smaller ones")
    return low, best


def _shelved(extents: Array, density: float, side_px: int) -> list[tuple[int, int]] | None:
    """Corners of frames put on shelves, tallest first; None if they don't fit."""
    sizes = np.array([_pixels(extent, density) for extent in extents]) + 2 * GUTTER_PX
    corners = [(0, 0)] * len(sizes)
    x = y = shelf = 0
    for k in np.argsort(-sizes[:, 1], kind="stable"):
        width, height = (int(v) for v in sizes[k])
        if x + width > side_px:
            x, y, shelf = 0, y + shelf, 0
        if width > side_px or y + height > side_px:
            return None
        corners[int(k)] = (x, y)
        x, shelf = x + width, max(shelf, height)
    return corners
