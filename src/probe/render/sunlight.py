"""From a panorama to light for a table: the brightest spot becomes a sun, exposure is set.

Knows no engine and no files.
"""

from __future__ import annotations

import math

import numpy as np

from probe.assets.environments.lens import Taking, halved, out_of_focus
from probe.render.illumination import Illumination, Sun, directions, solid_angles
from probe.types import Array, Vector3

SPOT = math.radians(25)
"""What is too bright within this angle of the brightest place goes to the sun."""

LOWEST = math.radians(30)
"""A lower sun is raised to this: shadows several times as long as things are high hide things."""

SHARES = (0.2, 0.6)
"""Least and greatest part of the light on the table that comes from the sun."""

WHITE = 0.8
"""A white card's brightest channel on the table, linear: 0.8 is 231 of 255."""

_LUMINANCE = np.array([0.2126, 0.7152, 0.0722])
_SEARCH_PX = 64


def illuminate(radiance: Array, yaw: float, taking: Taking | None = None) -> Illumination:
    """Light of a panorama that is turned about the vertical.

    Args:
        radiance: Linear RGB, shape (h, 2 h, 3), at yaw 0 as Illumination has it.
        yaw: Radians, anticlockwise seen from above; to the nearest column.
        taking: How a camera takes it; by default the brightest channel of a white card is WHITE,
            and the surroundings are in focus.
    """
    turned = _turned(radiance.astype(np.float32), yaw)
    dimmed, towards, colour = _without_spot(turned)
    sky = _on_table(dimmed)
    sun = _balanced(colour * towards[2], sky)
    raised = _raised(towards)
    if taking is None:
        scale = WHITE / float((sky + sun).max())
        lamp = Sun(raised, _triple(sun * scale / raised[2]))
        return Illumination(_half(dimmed * scale), lamp, _half(turned * scale))
    gains = (np.array(taking.white) / (sky + sun)).astype(np.float32)
    lamp = Sun(raised, _triple(sun * gains / raised[2]), taking.sun_size, taking.sun_distance)
    behind = gains * np.float32(taking.backdrop_gain)
    blurred = out_of_focus(turned, taking.blur_deg)
    return Illumination(_half(halved(dimmed) * gains), lamp, _half(blurred * behind))


def _turned(panorama: Array, yaw: float) -> Array:
    return np.roll(panorama, -round(yaw / (2 * np.pi) * panorama.shape[1]), axis=1)


def _triple(values: Array) -> Vector3:
    return float(values[0]), float(values[1]), float(values[2])


def _half(panorama: Array) -> Array:
    return np.minimum(panorama, 60_000).astype(np.float16)


def _without_spot(panorama: Array) -> tuple[Array, Vector3, Array]:
    """The panorama with its brightest spot dimmed, where that is, and its light.

    The light is over pi, on a surface that faces it, shape (3,). Dimmed is what outshines the
    ring around the spot.
    """
    height = panorama.shape[0]
    towards, weights = directions(height), solid_angles(height)
    middle = _brightest(panorama, towards)
    cosine = towards @ middle
    light = panorama @ _LUMINANCE.astype(np.float32)
    ring = (cosine < math.cos(SPOT)) & (cosine > math.cos(1.6 * SPOT)) & (towards[..., 2] > 0)
    usual = max(float(np.median(light[ring])), 1e-4)
    kept = np.where(cosine > math.cos(SPOT), np.minimum(1, usual / np.maximum(light, 1e-9)), 1)
    excess = panorama * (1 - kept)[..., None] * weights[..., None]
    colour = excess.sum(axis=(0, 1)) / np.pi
    pull = (excess @ _LUMINANCE)[..., None] * towards
    centre = pull.sum(axis=(0, 1))
    centre = centre / np.linalg.norm(centre) if np.linalg.norm(centre) > 0 else middle
    dimmed = (panorama * kept[..., None]).astype(np.float32)
    return dimmed, (float(centre[0]), float(centre[1]), max(float(centre[2]), 1e-3)), colour


def _brightest(panorama: Array, towards: Array) -> Array:
    """Unit vector to the middle of the block above the horizon that lights the table most."""
    block = max(1, panorama.shape[0] // _SEARCH_PX)
    rows = panorama.shape[0] // block // 2
    upper = slice(0, rows * block)
    lit = (
        (panorama[upper] @ _LUMINANCE)[..., None]
        * towards[upper]
        * solid_angles(panorama.shape[0])[upper, :, None]
    )
    sums = lit.reshape(rows, block, -1, block, 3).sum(axis=(1, 3))
    # A block's light on a table that leans towards it: how high it stands hardly matters.
    best = np.unravel_index(np.argmax(np.linalg.norm(sums, axis=-1)), sums.shape[:2])
    return sums[best] / np.linalg.norm(sums[best])


def _on_table(panorama: Array) -> Array:
    """Irradiance over pi of an upward surface, shape (3,)."""
    height = panorama.shape[0]
    weight = np.maximum(directions(height)[..., 2], 0) * solid_angles(height)
    return np.einsum("hw,hwc->c", weight, panorama) / np.pi


def _balanced(sun: Array, sky: Array) -> Array:
    """The sun's light on the table, made stronger or weaker until its share is lawful."""
    from_sun, from_sky = float(sun @ _LUMINANCE), float(sky @ _LUMINANCE)
    share = min(max(from_sun / (from_sun + from_sky), SHARES[0]), SHARES[1])
    colour = sun / from_sun if from_sun > 0 else sky / from_sky
    return colour * from_sky * share / (1 - share)


def _raised(towards: Vector3) -> Vector3:
    """The same compass direction, not below the lowest sun."""
    x, y, z = towards
    flat = math.hypot(x, y)
    up = max(math.atan2(z, flat), LOWEST)
    east, north = (x / flat, y / flat) if flat > 1e-9 else (1.0, 0.0)
    return (math.cos(up) * east, math.cos(up) * north, math.sin(up))
