"""How different two colours look."""

from __future__ import annotations

import numpy as np

from probe.types import Array

_BEND = 25.0**7


def ciede2000(one: Array, other: Array) -> Array:
    """CIEDE2000 difference of CIELAB colours, shapes (..., 3), with all weights 1, shape (...).

    Formula and names of terms as in Sharma, Wu and Dalal, "The CIEDE2000 color-difference
    formula: implementation notes, supplementary test data, and mathematical observations",
    Color Research and Application 30(1), 2005.
    """
    l1, a1, b1 = np.moveaxis(np.asarray(one, float), -1, 0)
    l2, a2, b2 = np.moveaxis(np.asarray(other, float), -1, 0)
    chroma = (np.hypot(a1, b1) + np.hypot(a2, b2)) / 2
    stretch = 1 + 0.5 * (1 - np.sqrt(chroma**7 / (chroma**7 + _BEND)))
    c1, c2 = np.hypot(stretch * a1, b1), np.hypot(stretch * a2, b2)
    h1, h2 = _hue(stretch * a1, b1), _hue(stretch * a2, b2)
    coloured = c1 * c2 > 0
    turn = np.where(coloured, (h2 - h1 + 180) % 360 - 180, 0.0)
    lightness, c_mean = (l1 + l2) / 2, (c1 + c2) / 2
    h_mean = np.where(coloured, (h1 + turn / 2) % 360, h1 + h2)
    hue = 2 * np.sqrt(c1 * c2) * np.sin(np.radians(turn / 2))
    t = (
        1
        - 0.17 * _cos(h_mean - 30)
        + 0.24 * _cos(2 * h_mean)
        + 0.32 * _cos(3 * h_mean + 6)
        - 0.20 * _cos(4 * h_mean - 63)
    )
    off = (lightness - 50) ** 2
    dl = (l2 - l1) / (1 + 0.015 * off / np.sqrt(20 + off))
    dc = (c2 - c1) / (1 + 0.045 * c_mean)
    dh = hue / (1 + 0.015 * c_mean * t)
    angle = 60 * np.exp(-(((h_mean - 275) / 25) ** 2))
    rotation = -2 * np.sqrt(c_mean**7 / (c_mean**7 + _BEND)) * np.sin(np.radians(angle))
    difference: Array = np.sqrt(dl**2 + dc**2 + dh**2 + rotation * dc * dh)
    return difference


def _hue(a: Array, b: Array) -> Array:
    return np.degrees(np.arctan2(b, a)) % 360


def _cos(degrees: Array) -> Array:
    return np.cos(np.radians(degrees))
