"""Cube maps as KTX1 files of packed floats. Knows no light and no engine."""

from __future__ import annotations

import struct
from collections.abc import Sequence

import numpy as np

from probe.types import Array

_IDENTIFIER = b"\xabKTX 11\xbb\r\n\x1a\n"
_R11F_G11F_B10F = 0x8C3A
_RGB = 0x1907
_FACES = 6
LARGEST = 64_512.0
"""The largest number that ten bits hold as a float (EXT_packed_float)."""


def cube_map(levels: Sequence[Array], metadata: dict[str, str] | None = None) -> bytes:
    """A cube map with its mip levels as a KTX 1.0 file (Khronos).

    Args:
        levels: From the largest: linear radiance, shape (6, n, n, 3), faces in the order
            +X -X +Y -Y +Z -Z; each level half as wide as the one before.
        metadata: Key-value data.
    """
    entries = b"".join(_entry(key, text) for key, text in (metadata or {}).items())
    size_px = levels[0].shape[1]
    # As Filament's own tool writes it and its reader wants it: the packed format is the type too.
    header = struct.pack(
        "<13I",
        *(0x04030201, _R11F_G11F_B10F, 1, _RGB, _R11F_G11F_B10F, _R11F_G11F_B10F),
        *(size_px, size_px, 0, 0, _FACES, len(levels), len(entries)),
    )
    return _IDENTIFIER + header + entries + b"".join(_level(level) for level in levels)


def _entry(key: str, text: str) -> bytes:
    content = f"{key}\0{text}\0".encode()
    return struct.pack("<I", len(content)) + content + b"\0" * (-len(content) % 4)


def _level(faces: Array) -> bytes:
    """One mip level; its length field counts a single face (KTX 1.0, section 2.16)."""
    packed = packed_floats(faces)
    return struct.pack("<I", packed[0].nbytes) + packed.tobytes()


def packed_floats(radiance: Array) -> Array:
    """Unsigned 11, 11 and 10 bit floats in a uint32, shape (...,), of numbers (..., 3).

    These floats are halves without sign and without the last bits (EXT_packed_float).
    """
    halves = np.clip(radiance, 0.0, LARGEST).astype(np.float16).view(np.uint16).astype(np.uint32)
    red, green, blue = halves[..., 0] >> 4, halves[..., 1] >> 4, halves[..., 2] >> 5
    return (red & 0x7FF) | (green & 0x7FF) << 11 | (blue & 0x3FF) << 22
