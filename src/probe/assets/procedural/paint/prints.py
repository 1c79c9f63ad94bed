"""Printed things: labels, covers, boxes, faces of dice, keys. Knows no shapes."""

from __future__ import annotations

from typing import Literal

import numpy as np
from PIL import Image

from probe.assets.procedural.paint.canvas import Canvas, mix, shade, step
from probe.assets.procedural.paint.colours import rgb
from probe.assets.procedural.paint.data import Data
from probe.assets.procedural.paint.elements import AnyElement, ink
from probe.types import Array


class Print(Data):
    """Things printed on paper, card, cloth or plastic.

    Attributes:
        ground: Colour of the unprinted surface.
        elements: Printed in this order.
        repeat: How often the print is repeated from left to right.
        wear: Strength of rubbed edges, 0-1.
        bare: What shows where it is rubbed.
        grain: Strength of the grain of the paper.
    """

    look: Literal["print"] = "print"
    ground: str
    elements: tuple[AnyElement, ...] = ()
    repeat: int = 1
    wear: float = 0.3
    bare: str = "white"
    grain: float = 0.02

    def draw(self, canvas: Canvas, rng: np.random.Generator) -> Array:
        size = (2 * max(8, canvas.width_px // self.repeat), 2 * canvas.height_px)
        image = Image.new("RGB", size, ink(self.ground))
        for element in self.elements:
            element.draw(image)
        once = np.asarray(image.reduce(2), dtype=np.float32) / 255
        picture = np.tile(once, (1, self.repeat, 1))
        short = canvas.width_px - picture.shape[1]
        picture = np.pad(picture, ((0, 0), (0, max(0, short)), (0, 0)), mode="edge")
        picture = picture[:, : canvas.width_px]
        return self._worn(picture, canvas, rng)

    def _worn(self, picture: Array, canvas: Canvas, rng: np.random.Generator) -> Array:
        x, y = canvas.across(), canvas.down()
        edge = np.minimum(np.minimum(x, x[:, ::-1]), np.minimum(y, y[::-1]))
        rubbed = np.exp(-edge / 0.0012) + 0.35 * canvas.noise(rng, 0.004, octaves=3)
        picture = mix(picture, rgb(self.bare), step(rubbed, 0.75, 1.3) * self.wear)
        fine = rng.standard_normal(canvas.shape, dtype=np.float32) * self.grain
        return shade(picture, fine + canvas.noise(rng, 0.02, octaves=2) * 0.02)
