"""A panorama as image-based light: blurred by roughness on cube faces. Knows no engine.

Cube directions are Filament's: (x, z, -y) of the world.
"""

from __future__ import annotations

import numpy as np

from probe.render.illumination import directions, solid_angles
from probe.render.ktx import cube_map
from probe.types import Array

LIGHT_VERSION = "1"
"""Changes with what light_map makes of a panorama."""

FACE_PX = 128
BACKDROP_PX = 512
_FOCUS_PX = (1.2, 1.2, 0.0)
_LEVELS = 5
_SAMPLES = (0, 16, 64, 128, 256)
_WIDTHS = (1024, 256, 128, 64, 32)
_FACE_AXES = (
    ((0, 0, -1), (0, -1, 0), (1, 0, 0)),
    ((0, 0, 1), (0, -1, 0), (-1, 0, 0)),
    ((1, 0, 0), (0, 0, 1), (0, 1, 0)),
    ((1, 0, 0), (0, 0, -1), (0, -1, 0)),
    ((1, 0, 0), (0, -1, 0), (0, 0, 1)),
    ((-1, 0, 0), (0, -1, 0), (0, 0, -1)),
)
"""Right, down and outwards of each face in cube directions (OpenGL 4.6, table 8.19)."""


def light_map(radiance: Array) -> bytes:
    """Image-based light as a KTX1 file: a mip level for each roughness, and harmonics.

    Args:
        radiance: A panorama as Illumination has it.
    """
    if (radiance == radiance[0, 0]).all():
        return _even_map(radiance[0, 0])
    levels: list[Array] = []
    for level, (samples, width) in enumerate(zip(_SAMPLES, _WIDTHS, strict=True)):
        outwards = face_directions(FACE_PX >> level)
        source = reduced(radiance, width)
        # Filament reads roughness r (its square is GGX's alpha) from level n r (2 - r).
        roughness = 1 - np.sqrt(1 - level / (_LEVELS - 1))
        levels.append(_blurred(source, outwards, roughness**2, samples))
    return cube_map(levels, {"sh": _table(harmonics(radiance))})


def _even_map(colour: Array) -> bytes:
    """The same light from everywhere: exact, and small."""
    bands = np.zeros((9, 3))
    bands[0] = colour
    levels = [colour + np.zeros((6, 16 >> level, 16 >> level, 3)) for level in range(_LEVELS)]
    return cube_map(levels, {"sh": _table(bands)})


def _table(rows: Array) -> str:
    return "".join(" ".join(f"{value:.7g}" for value in row) + "\n" for row in rows)


def backdrop_map(radiance: Array) -> bytes:
    """The panorama as a cube map, a KTX1 file: a little out of focus, as behind a table."""
    # Its import takes 0.25 s, and most renderers find the map in the cache.
    from scipy.ndimage import gaussian_filter

    soft = gaussian_filter(radiance.astype(np.float32), _FOCUS_PX, mode=("nearest", "wrap", "wrap"))
    return cube_map([look_up(soft, face_directions(BACKDROP_PX))])


def face_directions(size_px: int) -> Array:
    """World directions through the texels of a cube's faces, shape (6, n, n, 3)."""
    place = (np.arange(size_px) + 0.5) / size_px * 2 - 1
    s, t = place[None, None, :, None], place[None, :, None, None]
    right, down, out = (np.array(axes)[:, None, None, :] for axes in zip(*_FACE_AXES, strict=True))
    cube = out + s * right + t * down
    cube = cube / np.linalg.norm(cube, axis=-1, keepdims=True)
    return np.stack([cube[..., 0], -cube[..., 2], cube[..., 1]], axis=-1)


def look_up(panorama: Array, towards: Array) -> Array:
    """Radiance in some directions, (..., 3), between the nearest four pixels."""
    height, width = panorama.shape[:2]
    round_ = np.arctan2(towards[..., 0], towards[..., 1])
    u = (round_ / np.pi + 1) * width / 2 - 0.5
    v = (0.5 - np.arcsin(np.clip(towards[..., 2], -1, 1)) / np.pi) * height - 0.5
    left, top = np.floor(u).astype(int), np.floor(v).astype(int)
    fu, fv = (u - left)[..., None].astype(np.float32), (v - top)[..., None].astype(np.float32)
    rows = np.clip(top, 0, height - 1), np.clip(top + 1, 0, height - 1)
    columns = left % width, (left + 1) % width
    upper = panorama[rows[0], columns[0]] * (1 - fu) + panorama[rows[0], columns[1]] * fu
    lower = panorama[rows[1], columns[0]] * (1 - fu) + panorama[rows[1], columns[1]] * fu
    return upper * (1 - fv) + lower * fv


def reduced(panorama: Array, width: int) -> Array:
    """A panorama of at most this width, float32, by means over blocks."""
    block = max(1, panorama.shape[1] // width)
    height = max(1, panorama.shape[0] // block)
    parts = panorama[: height * block].astype(np.float32)
    return parts.reshape(height, block, -1, block, 3).mean(axis=(1, 3))


def harmonics(radiance: Array) -> Array:
    """Irradiance over pi as nine polynomials' coefficients, shape (9, 3), in Filament's order.

    Ramamoorthi and Hanrahan, "An Efficient Representation for Irradiance Environment Maps"
    (SIGGRAPH 2001): the cosine lobe scales the bands by 1, 2/3 and 1/4. The polynomials 1; y, z,
    x; xy, yz, 3z2-1, zx, x2-y2 of cube directions carry the squares of their norms.
    """
    height = 128
    towards = directions(height)
    panorama = look_up(reduced(radiance, 2 * height), towards)
    weights = solid_angles(height) + np.zeros((1, 2 * height))
    x, y, z = towards[..., 0], towards[..., 2], -towards[..., 1]
    bands = [np.ones_like(x), y, z, x, y * x, y * z, 3 * z * z - 1, z * x, x * x - y * y]
    norms = np.array([1, *[3] * 3, 15, 15, 5 / 4, 15, 15 / 4]) / (4 * np.pi)
    lobe = np.array([1, *[2 / 3] * 3, *[1 / 4] * 5])
    sums = np.einsum("khw,hw,hwc->kc", np.stack(bands), weights, panorama)
    return sums * (norms * lobe)[:, None]


def _blurred(panorama: Array, outwards: Array, alpha: float, samples: int) -> Array:
    """Radiance weighted by GGX of this alpha as if seen head on (Karis, SIGGRAPH 2013)."""
    if samples == 0:
        return look_up(panorama, outwards)
    aside = np.where(np.abs(outwards[..., 2:]) < 0.9, [0.0, 0.0, 1.0], [1.0, 0.0, 0.0])
    first = np.cross(aside, outwards)
    first = first / np.linalg.norm(first, axis=-1, keepdims=True)
    second = np.cross(outwards, first)
    total = np.zeros(outwards.shape, np.float32)
    weight = 0.0
    for lobe in _lobe(alpha, samples):
        total += np.float32(lobe[2]) * look_up(
            panorama, lobe[0] * first + lobe[1] * second + lobe[2] * outwards
        )
        weight += lobe[2]
    return total / np.float32(weight)


def _lobe(alpha: float, samples: int) -> Array:
    """Directions (n, 3) reflected at GGX's half vectors, evenly spread (Hammersley)."""
    number = np.arange(samples)
    bits = [(number >> k & 1) / 2 ** (k + 1) for k in range(16)]
    turn = 2 * np.pi * (number + 0.5) / samples
    chance = np.sum(bits, axis=0) + 0.5 / samples
    cos2 = (1 - chance) / (1 + (alpha**2 - 1) * chance)
    flat = 2 * np.sqrt(cos2 * (1 - cos2))
    lobe = np.stack([flat * np.cos(turn), flat * np.sin(turn), 2 * cos2 - 1], axis=-1)
    return lobe[lobe[:, 2] > 0]
