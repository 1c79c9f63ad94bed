"""Puts a film's picture together: question, stage, what the agent saw, captions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from PIL import Image, ImageDraw

from probe.episodes.turns import Question
from probe.film.captions import Caption
from probe.film.cutting import FilmShot
from probe.film.lettering import Ink, font, write
from probe.types import Array

SIZE_PX = (1280, 720)
STAGE_PX = (864, 616)
"""Width and height of the film, and of the stage in it."""

_TOP_PX = SIZE_PX[1] - STAGE_PX[1]
_INSET_PX = 344
_MARGIN = 20
PAPER: Ink = (22, 25, 31)
_BAR: Ink = (32, 37, 46)
_WHITE: Ink = (245, 246, 248)
_GREY: Ink = (168, 176, 188)
_BLUE: Ink = (134, 190, 240)
_GREEN: Ink = (150, 220, 160)
_RED: Ink = (244, 160, 150)


@dataclass
class Layout:
    """Draws whole frames; what stays the same between frames is kept.

    Attributes:
        question: What was asked.
        captions: One a call.
        pictures: What the agent had last seen before each call, and after the last; uint8.
        inset: What these are called.
        note: Stands on the stage wherever no speed does.
    """

    question: Question
    captions: Sequence[Caption]
    pictures: Sequence[Array]
    inset: str = "What the agent saw last"
    note: str = ""
    _kept: tuple[tuple[int | None, bool], Image.Image] | None = field(default=None, init=False)

    def frame(self, shot: FilmShot, stage: Array) -> Array:
        """A frame of SIZE_PX, uint8, with a picture of the stage of STAGE_PX."""
        state = (shot.call, shot.told)
        if self._kept is None or self._kept[0] != state:
            self._kept = state, self._surroundings(shot)
        frame = self._kept[1].copy()
        frame.paste(Image.fromarray(stage), (0, _TOP_PX))
        words = self.note if shot.speed is None else speed_words(shot.speed)
        if words:
            _badge(frame, words)
        return np.asarray(frame)

    def _surroundings(self, shot: FilmShot) -> Image.Image:
        frame = Image.new("RGB", SIZE_PX, PAPER)
        pen = ImageDraw.Draw(frame)
        pen.rectangle((0, 0, SIZE_PX[0], _TOP_PX - 1), fill=_BAR)
        width = SIZE_PX[0] - 2 * _MARGIN
        used = write(pen, (_MARGIN, 12), self.question.text, 23, _WHITE, (width, 60))
        options = "     ".join(f"{letter}  {text}" for letter, text in self.question.options)
        write(pen, (_MARGIN, 16 + used), options, 18, _GREY, (width, _TOP_PX - used - 18))
        self._inset(frame, pen, shot)
        self._texts(pen, shot)
        return frame

    def _inset(self, frame: Image.Image, pen: ImageDraw.ImageDraw, shot: FilmShot) -> None:
        left = STAGE_PX[0] + _MARGIN
        pen.text((left, _TOP_PX + 8), self.inset, fill=_GREY, font=font(15))
        seen = 0 if shot.call is None else shot.call + shot.told
        picture = Image.fromarray(self.pictures[seen])
        small = picture.resize((_INSET_PX, _INSET_PX), Image.Resampling.BOX)
        frame.paste(small, (left, _TOP_PX + 30))

    def _texts(self, pen: ImageDraw.ImageDraw, shot: FilmShot) -> None:
        if shot.call is None:
            return
        caption = self.captions[shot.call]
        told = _RED if caption.bad else _GREEN
        lines = [
            (caption.heading, 15, _GREY),
            (caption.words, 17, _WHITE),
            (caption.call, 18, _BLUE),
            (caption.result if shot.told else "", 17, told),
        ]
        left, top = STAGE_PX[0] + _MARGIN, _TOP_PX + 30 + _INSET_PX + 10
        for text, size, ink in lines:
            if text:
                room = (SIZE_PX[0] - left - _MARGIN, SIZE_PX[1] - top - 8)
                top += write(pen, (left, top), text, size, ink, room) + 5


def speed_words(speed: float) -> str:
    """A speed as a film states it."""
    return "real time" if speed == 1 else f"{speed:g}x speed"


def _badge(frame: Image.Image, words: str) -> None:
    """The speed, in the stage's lower left corner."""
    face = font(20)
    width = round(face.getlength(words))
    left, bottom = 16, SIZE_PX[1] - 16
    pen = ImageDraw.Draw(frame)
    box = (left, bottom - 36, left + width + 24, bottom)
    pen.rounded_rectangle(box, radius=10, fill=PAPER)
    pen.text((left + 12, bottom - 18), words, fill=_WHITE, font=face, anchor="lm")
