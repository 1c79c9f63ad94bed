"""Light as the renderer takes it: environment maps packed as KTX1 cube maps."""

from __future__ import annotations

import struct

import numpy as np

_IDENTIFIER = b"\xabKTX 11\xbb\r\n\x1a\n"
_R11F_G11F_B10F = 0x8C3A
_RGB = 0x1907
_FACES = 6

AMBIENT_RADIANCE = 1.0
"""The exposure makes the flat grey dome (0.85 at strength 0.8) show a white card as white."""

UNIT_INTENSITY = 39321.6
"""Intensity of an image light at which radiance 1 shows a surface in its own colour (measured)."""


def uniform_environment(radiance: float, size_px: int = 16) -> bytes:
    """A cube map of one grey radiance, with its spherical harmonics, as a KTX1 file.

    KTX 1.0 specification (Khronos): header, key-value data, then mip levels of six faces. The
    harmonics are Filament's "sh" entry: nine RGB rows, of which a uniform dome has only the first.
    """
    pixel = struct.pack("<I", _r11g11b10(radiance))
    harmonics = "\n".join([f"{radiance} {radiance} {radiance}", *["0 0 0"] * 8]) + "\n"
    entry = b"sh\0" + harmonics.encode() + b"\0"
    metadata = struct.pack("<I", len(entry)) + entry
    metadata += b"\0" * (-len(metadata) % 4)
    levels = size_px.bit_length()
    header = struct.pack(
        "<13I",
        *(0x04030201, _R11F_G11F_B10F, 1, _RGB, _R11F_G11F_B10F, _R11F_G11F_B10F),
        *(size_px, size_px, 0, 0, _FACES, levels, len(metadata)),
    )
    mips = b"".join(_uniform_level(size_px >> level, pixel) for level in range(levels))
    return _IDENTIFIER + header + metadata + mips


def _uniform_level(size_px: int, pixel: bytes) -> bytes:
    return struct.pack("<I", size_px**2 * 4) + pixel * (size_px**2 * _FACES)


def _r11g11b10(value: float) -> int:
    """Pack one grey value into unsigned 11, 11 and 10 bit floats (EXT_packed_float)."""
    half = int(np.float16(value).view(np.uint16))
    eleven, ten = half >> 4 & 0x7FF, half >> 5 & 0x3FF
    return eleven | eleven << 11 | ten << 22
