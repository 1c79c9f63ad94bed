"""Marks that prints consist of: words, blocks, bars, balls, hills. Knows no surfaces."""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import Annotated, Literal

import numpy as np
from PIL import Image, ImageDraw, ImageFont
from pydantic import Field

from probe.assets.procedural.paint.canvas import mix
from probe.assets.procedural.paint.colours import rgb
from probe.assets.procedural.paint.data import Data
from probe.types import Array

Frame = tuple[float, float, float, float]  # left, top, right, bottom as shares of the print
FONT_SIZE = 120
SMALL_PRINT = (
    "Keep in a cool dry place. Once opened use within three days. Ingredients: water, salt, "
    "sugar, natural flavour, citric acid. May contain traces of nuts. Best before end: see "
    "base. Net weight as packed. Recycle where facilities exist. Made with care since 1962. "
)


def ink(colour: str) -> tuple[int, int, int]:
    """A colour as PIL takes it."""
    red, green, blue = (round(float(v) * 255) for v in rgb(colour))
    return (red, green, blue)


class Element(Data, ABC):
    """One thing printed inside a frame."""

    at: Frame
    fill: str

    @abstractmethod
    def draw(self, image: Image.Image) -> None: ...

    def box(self, image: Image.Image) -> tuple[int, int, int, int]:
        """The frame in pixels."""
        w, h = image.size
        left, top, right, bottom = self.at
        return (round(left * w), round(top * h), round(right * w), round(bottom * h))


class Block(Element):
    """A filled rectangle; ``round`` is the corner radius as a share of its height."""

    kind: Literal["block"]
    round: float = 0.0
    outline: float = 0.0

    def draw(self, image: Image.Image) -> None:
        box = self.box(image)
        height = min(box[3] - box[1], box[2] - box[0])
        pen = ImageDraw.Draw(image)
        if self.outline > 0:
            width = max(2, round(self.outline * height))
            pen.rounded_rectangle(box, self.round * height, outline=ink(self.fill), width=width)
        else:
            pen.rounded_rectangle(box, self.round * height, fill=ink(self.fill))


class Text(Element):
    """Words as large as the frame allows; ``bold`` thickens strokes, ``slant`` leans them."""

    kind: Literal["text"]
    words: str
    bold: int = 0
    slant: float = 0.0
    turned: bool = False

    def draw(self, image: Image.Image) -> None:
        mask = self._mask()
        left, top, right, bottom = self.box(image)
        scale = min((right - left) / mask.width, (bottom - top) / mask.height)
        size = (max(1, round(mask.width * scale)), max(1, round(mask.height * scale)))
        mask = mask.resize(size, Image.Resampling.LANCZOS)
        corner = ((left + right - size[0]) // 2, (top + bottom - size[1]) // 2)
        image.paste(ink(self.fill), (*corner, corner[0] + size[0], corner[1] + size[1]), mask)

    def _mask(self) -> Image.Image:
        font = ImageFont.load_default(FONT_SIZE)
        left, top, right, bottom = font.getbbox(self.words, stroke_width=self.bold)
        lean = abs(self.slant) * (bottom - top)
        mask = Image.new("L", (int(right - left + lean) + 2, int(bottom - top) + 2))
        pen = ImageDraw.Draw(mask)
        pen.text((1 - left, 1 - top), self.words, fill=255, font=font, stroke_width=self.bold)
        if self.slant:
            skew = (1, self.slant, -lean, 0, 1, 0)
            mask = mask.transform(mask.size, Image.Transform.AFFINE, skew, Image.Resampling.BICUBIC)
        return mask.transpose(Image.Transpose.ROTATE_90) if self.turned else mask


class SmallPrint(Element):
    """Rows of words too small to matter."""

    kind: Literal["small print"]
    rows: int

    def draw(self, image: Image.Image) -> None:
        left, top, right, bottom = self.box(image)
        pitch = (bottom - top) / self.rows
        font = ImageFont.load_default(max(6, pitch * 0.8))
        pen = ImageDraw.Draw(image)
        letters = max(4, int((right - left) / (pitch * 0.4)))
        for row in range(self.rows):
            start = row * letters % len(SMALL_PRINT)
            words = (SMALL_PRINT * 2)[start : start + letters - 5 * (row % 3 == 2)]
            pen.text((left, top + row * pitch), words, fill=ink(self.fill), font=font)


class Barcode(Element):
    """Upright bars on white."""

    kind: Literal["barcode"]

    def draw(self, image: Image.Image) -> None:
        left, top, right, bottom = self.box(image)
        pen = ImageDraw.Draw(image)
        pen.rectangle((left, top, right, bottom), fill=(245, 245, 243))
        module, margin = (right - left) / 60, (bottom - top) / 20
        pattern = "11010010111001001101110100011010111001000101110110010"
        for k, bar in enumerate(pattern):
            if bar == "1":
                x = left + (k + 3.5) * module
                bar_box = (x, top + margin, x + module, bottom - 2 * margin)
                pen.rectangle(bar_box, fill=ink(self.fill))


class Disc(Element):
    """An ellipse, flat or shaded like a ball under a lamp."""

    kind: Literal["disc"]
    ball: bool = False
    ring: float = 0.0

    def draw(self, image: Image.Image) -> None:
        box = self.box(image)
        if self.ball:
            _paste_ball(image, box, rgb(self.fill))
        elif self.ring > 0:
            width = max(2, round(self.ring * (box[3] - box[1])))
            ImageDraw.Draw(image).ellipse(box, outline=ink(self.fill), width=width)
        else:
            ImageDraw.Draw(image).ellipse(box, fill=ink(self.fill))


class Polygon(Element):
    """A closed outline; points as shares of the frame."""

    kind: Literal["polygon"]
    points: tuple[tuple[float, float], ...]

    def draw(self, image: Image.Image) -> None:
        left, top, right, bottom = self.box(image)
        outline = [(left + x * (right - left), top + y * (bottom - top)) for x, y in self.points]
        ImageDraw.Draw(image).polygon(outline, fill=ink(self.fill))


class Grid(Element):
    """The same mark in rows and columns: dots, keys, holes, stripes (one row or column)."""

    kind: Literal["grid"]
    columns: int = 1
    rows: int = 1
    size: tuple[float, float]  # of one mark as a share of its cell
    round: float = 0.0

    def draw(self, image: Image.Image) -> None:
        left, top, right, bottom = self.box(image)
        w, h = (right - left) / self.columns, (bottom - top) / self.rows
        half_w, half_h = self.size[0] * w / 2, self.size[1] * h / 2
        corner = self.round * min(half_w, half_h) * 2
        pen = ImageDraw.Draw(image)
        for i in range(self.columns):
            for j in range(self.rows):
                x, y = left + (i + 0.5) * w, top + (j + 0.5) * h
                mark = (x - half_w, y - half_h, x + half_w, y + half_h)
                pen.rounded_rectangle(mark, corner, fill=ink(self.fill))


class Hills(Element):
    """A landscape: sky that fades to the horizon, and ridges in front of each other."""

    kind: Literal["hills"]
    sky: str
    glow: str
    seed: int = 0

    def draw(self, image: Image.Image) -> None:
        left, top, right, bottom = self.box(image)
        w, h = right - left, bottom - top
        rng = np.random.default_rng(self.seed)
        fade = np.linspace(0, 1, h, dtype=np.float32)[:, None]
        picture = np.broadcast_to(mix(rgb(self.sky), rgb(self.glow), fade), (h, w, 3)).copy()
        x, y = np.linspace(0, 1, w), np.linspace(0, 1, h)[:, None]
        for k in range(4):
            waves = np.zeros(w)
            for f in (1, 2, 5, 11):
                waves += rng.uniform(0.3, 1) / f * np.sin(6.3 * (f * x * 0.7 + rng.uniform()))
            ridge = 0.45 + 0.14 * k + 0.06 * waves
            colour = mix(rgb(self.glow), rgb(self.fill), 0.35 + 0.2 * k)
            picture = np.where((y > ridge)[..., None], colour, picture)
        image.paste(Image.fromarray((np.clip(picture, 0, 1) * 255).astype(np.uint8)), (left, top))


def _paste_ball(image: Image.Image, box: tuple[int, int, int, int], colour: Array) -> None:
    left, top, right, bottom = box
    w, h = max(2, right - left), max(2, bottom - top)
    x = np.linspace(-1, 1, w)[None]
    y = np.linspace(-1, 1, h)[:, None]
    inside = x * x + y * y
    z = np.sqrt(np.clip(1 - inside, 0, 1))
    light = np.clip(0.45 * z - 0.35 * x - 0.6 * y, 0, 1)
    glint = np.clip((light - 0.78) / 0.1, 0, 1) * 0.5
    tone = colour * (0.55 + 0.6 * light)[..., None]
    tone = tone + glint[..., None] * (1 - tone)
    ball = Image.fromarray((np.clip(tone, 0, 1) * 255).astype(np.uint8))
    mask = Image.fromarray((np.clip((1 - inside) * min(w, h) / 3, 0, 1) * 255).astype(np.uint8))
    image.paste(ball, (left, top), mask)


AnyElement = Annotated[
    Block | Text | SmallPrint | Barcode | Disc | Polygon | Grid | Hills, Field(discriminator="kind")
]
