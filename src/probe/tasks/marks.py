"""Draws the marks of Compare and Size on the first picture."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from probe.tasks.task import Mark
from probe.types import Array

_RADIUS_PX, _RIM_PX, _LETTER_PX = 3, 2, 26
_BESIDE_PX = 24
_INK, _RIM = (255, 255, 255), (0, 0, 0)


def drawn(picture: Array, marks: Sequence[Mark], size: int = 1) -> Array:
    """The picture, sRGB uint8, shape (h, w, 3), with a dot on each mark and its letter beside it.

    The letter lies towards the middle of the picture, so that it is never cut off.

    Args:
        picture: Where they are drawn.
        marks: Their places.
        size: Times the usual one, for a picture that is shown smaller than it is.
    """
    if not marks:
        return picture
    image = Image.fromarray(picture)
    pen = ImageDraw.Draw(image)
    font = ImageFont.load_default(size * _LETTER_PX)
    middle = np.array(image.size) / 2
    for mark in marks:
        u, v = mark.point
        for radius, colour in ((_RADIUS_PX + _RIM_PX, _RIM), (_RADIUS_PX, _INK)):
            pen.ellipse(
                [u - size * radius, v - size * radius, u + size * radius, v + size * radius],
                fill=colour,
            )
        beside = np.array(mark.point) + size * _BESIDE_PX * np.where(middle > mark.point, 1, -1)
        pen.text(
            (float(beside[0]), float(beside[1])),
            mark.letter,
            fill=_INK,
            font=font,
            anchor="mm",
            stroke_width=size * _RIM_PX,
            stroke_fill=_RIM,
        )
    return np.asarray(image)
