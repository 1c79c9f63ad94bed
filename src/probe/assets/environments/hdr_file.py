"""Reads panoramas of radiance: Radiance's .hdr and OpenEXR."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import numpy as np

from probe.errors import BadData
from probe.reading import MESH, contents, opened
from probe.types import Array

_LARGEST_PX = 16_384
_REMEDY = "Download it again; an equirectangular panorama, twice as wide as high, is needed."


def read_panorama(path: Path) -> Array:
    """Linear radiance, float32, shape (h, 2 h, 3), the top row overhead.

    Raises:
        BadData: The file is missing, damaged or no panorama, or its format can't be read here.
    """
    try:
        radiance = _read_exr(path) if path.suffix == ".exr" else _decoded(contents(path, MESH))
    except OSError as error:
        raise BadData(path, error.strerror or str(error), _REMEDY) from error
    except ValueError as error:
        raise BadData(path, str(error), _REMEDY) from error
    height, width = radiance.shape[:2]
    if width != 2 * height:
        raise BadData(path, f"is {width} x {height} pixels", _REMEDY)
    if not np.isfinite(radiance).all() or radiance.min() < 0 or radiance.max() <= 0:
        raise BadData(path, "holds no light, or numbers that are none", _REMEDY)
    return radiance


def _read_exr(path: Path) -> Array:
    """Colour of an OpenEXR picture.

    Raises:
        ValueError: It is none, or has no colour.
    """
    import OpenEXR  # takes 0.1 s, and hardly any process reads such a file

    try:
        _check_exr(path)
        with OpenEXR.File(str(path)) as file:
            channels: dict[str, Any] = file.channels()
            name = "RGB" if "RGB" in channels else "RGBA"
            return np.asarray(channels[name].pixels[..., :3], np.float32)
    except (RuntimeError, TypeError, KeyError) as error:
        raise ValueError(f"can't be read as OpenEXR ({error})") from error


def _check_exr(path: Path) -> None:
    """Refuse a picture that would fill the memory, by its header.

    Raises:
        OSError: It can't be read, or is no regular file.
        ValueError: It is too large.
    """
    import OpenEXR

    opened(path).close()
    with OpenEXR.File(str(path), header_only=True) as file:
        low, high = file.header()["dataWindow"]
        width, height = (int(edge) for edge in np.asarray(high) - np.asarray(low) + 1)
    if not (0 < width <= _LARGEST_PX and 0 < height <= _LARGEST_PX):
        raise ValueError(f"claims {width} x {height} pixels")


def _decoded(content: bytes) -> Array:
    """Pixels of a Radiance picture with shared exponents (Ward, "Real Pixels", Gems II, 1991).

    Raises:
        ValueError: It is none, or is cut short.
    """
    head, _, body = content.partition(b"\n\n")
    if not head.startswith(b"#?") or b"FORMAT=32-bit_rle_rgbe" not in head:
        raise ValueError("is no Radiance picture (32-bit_rle_rgbe)")
    size, _, rows = body.partition(b"\n")
    found = re.fullmatch(rb"-Y (\d+) \+X (\d+)", size.strip())
    if not found:
        raise ValueError("isn't stored from the top left, row by row")
    height, width = int(found[1]), int(found[2])
    if not (8 <= width <= _LARGEST_PX and 4 <= height <= _LARGEST_PX):
        raise ValueError(f"claims {width} x {height} pixels")
    rgbe = _unpacked(rows, height, width)
    scale = np.ldexp(np.float32(1), rgbe[..., 3:].astype(np.int32) - (128 + 8))
    return np.where(rgbe[..., 3:] > 0, rgbe[..., :3] * scale, 0).astype(np.float32)


def _unpacked(rows: bytes, height: int, width: int) -> Array:
    """Bytes of all pixels, uint8, shape (h, w, 4), each row flat or run-length coded."""
    if len(rows) == height * width * 4 and rows[:2] != b"\2\2":
        return np.frombuffer(rows, np.uint8).reshape(height, width, 4)
    picture = np.zeros((height, 4, width), np.uint8)
    at = 0
    for row in range(height):
        if rows[at : at + 4] != bytes((2, 2, width >> 8, width & 255)):
            raise ValueError(f"row {row} doesn't begin as it should")
        at += 4
        for channel in range(4):
            at = _run(rows, at, picture[row, channel])
    return picture.transpose(0, 2, 1)


def _run(rows: bytes, at: int, target: Array) -> int:
    """Fill one channel of one row from runs; returns where the next begins."""
    filled = 0
    while filled < len(target):
        if at + 1 >= len(rows):
            raise ValueError("is cut short")
        count = rows[at]
        repeated = count > 128
        count -= 128 if repeated else 0
        taken = 1 if repeated else count
        piece = np.frombuffer(rows, np.uint8, count=min(taken, len(rows) - at - 1), offset=at + 1)
        if count == 0 or filled + count > len(target) or len(piece) < taken:
            raise ValueError("has a run that leads nowhere")
        target[filled : filled + count] = piece
        filled += count
        at += 1 + taken
    return at
