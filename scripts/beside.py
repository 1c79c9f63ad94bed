"""Pictures of the documentation: two side by side, written at a height."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from PIL import Image

from probe.files import encode, write_bytes
from probe.types import Array

PICTURES = Path(__file__).parents[1] / "docs/pictures"
_GAP_PX = 12


def beside(one: Array, other: Array, side_px: int) -> Array:
    """Two pictures with a gap of 12 pixels between them once they are `side_px` high."""
    gap = np.full((one.shape[0], _GAP_PX * one.shape[0] // side_px, 3), 255, np.uint8)
    return np.concatenate([one, gap, other], axis=1)


def write_picture(name: str, picture: Array, side_px: int) -> None:
    """Write a picture of this height into docs/pictures."""
    image = Image.fromarray(picture)
    image = image.resize((round(image.width * side_px / image.height), side_px))
    write_bytes(PICTURES / name, encode(image, "JPEG"))
