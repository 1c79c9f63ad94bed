"""How a camera that is focused on the table takes the room around it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from probe.types import Array, Vector3

_PARTS = 4
"""Pixels of the disc's edge are covered as far as so many points across and down say."""


@dataclass(frozen=True)
class Taking:
    """Exposure, white balance and focus, and how wide the key light is.

    Attributes:
        white: Linear colour of a white card on the table.
        blur_deg: Diameter of the disc that a far point becomes.
        backdrop_gain: How much brighter the surroundings are shown than they shine.
        sun_size: As a Sun has it.
        sun_distance: As a Sun has it.
    """

    white: Vector3
    blur_deg: float
    backdrop_gain: float
    sun_size: float
    sun_distance: float


def taking(number: int) -> Taking:
    """How the room of this number is taken.

    Away from the usual white, red, green and blue change as those of a black body do, here
    from 7,200 K to 5,200 K.
    """
    rng = np.random.default_rng([4022, number])
    warmth = float(rng.uniform(-15, 38))
    tint = np.exp(warmth * np.array([0.0, -0.0055, -0.0100]))
    tint[1] *= np.exp(float(rng.uniform(-0.025, 0.025)))
    white = tint / tint.max() * 0.8 * 2 ** float(rng.uniform(-0.35, 0.28))
    return Taking(
        white=(float(white[0]), float(white[1]), float(white[2])),
        blur_deg=float(rng.uniform(1.3, 2.6)),
        backdrop_gain=float(rng.uniform(1.1, 2.4)),
        sun_size=float(rng.uniform(1.2, 3.0)),
        sun_distance=float(rng.uniform(1.8, 3.5)),
    )


def halved(panorama: Array) -> Array:
    """A panorama of half the width and height."""
    height = len(panorama) // 2
    return panorama.reshape(height, 2, 2 * height, 2, 3).mean(axis=(1, 3))


def out_of_focus(panorama: Array, degrees: float) -> Array:
    """A panorama in which each point has become a disc; true to shape near the horizon.

    Args:
        panorama: Linear radiance, shape (h, 2 h, 3).
        degrees: Diameter of the disc.
    """
    height = len(panorama)
    disc = _disc(degrees / 360 * height, height)
    spectrum = np.fft.rfft2(panorama, axes=(0, 1)) * np.fft.rfft2(disc)[..., None]
    blurred = np.fft.irfft2(spectrum, panorama.shape[:2], axes=(0, 1))
    return np.maximum(blurred, 0).astype(np.float32)


def _disc(radius: float, height: int) -> Array:
    """A disc around the first pixel, wrapped around, of sum 1; shape (h, 2 h)."""
    place = (np.arange(_PARTS) + 0.5) / _PARTS - 0.5
    v, u = (np.fft.fftfreq(size, 1 / size)[:, None] + place for size in (height, 2 * height))
    inside = (v[:, None, :, None] ** 2 + u[None, :, None, :] ** 2) < radius**2
    covered: Array = inside.mean(axis=(2, 3))
    return covered / covered.sum()
