"""Pictures of what a reply got wrong: the table before and after, with the things outlined."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from claims import Verdict
from PIL import Image, ImageDraw
from scipy import ndimage

from probe.types import Array, Frame

_SIDE = 512
_LINE_PX = 6
_RED = np.array([230, 20, 20], dtype=np.uint8)
_CAPTION = 96


@dataclass(frozen=True)
class Moments:
    """What the fixed camera showed before and after a manipulation."""

    before: Frame
    after: Frame
    names: dict[int, str]


def wrong_names(verdict: Verdict) -> list[str]:
    """The things about which a reply said nothing, or something false."""
    told = [*verdict.basket_unsaid, *verdict.unmentioned, *verdict.wrongly_unseen]
    told += [*verdict.mixed_up, *verdict.wrongly_turned]
    return [*told, verdict.target] if verdict.false_done else told


def keep(folder: Path, verdict: Verdict, moments: Moments, number: int) -> None:
    """Write the picture of a reply, if something was wrong with it."""
    wrong = wrong_names(verdict)
    if not wrong:
        return
    numbers = [n for n, name in moments.names.items() if name in wrong]
    sheet = Image.new("RGB", (2 * _SIDE, _SIDE + _CAPTION), "white")
    for place, frame in enumerate((moments.before, moments.after)):
        sheet.paste(_outlined(frame, numbers), (place * _SIDE, 0))
    text = f"{', '.join(wrong)} | {verdict.tool} {verdict.target}: {verdict.text}"
    ImageDraw.Draw(sheet).text((6, _SIDE + 4), "\n".join(textwrap.wrap(text, 165)[:6]), "black")
    folder.mkdir(parents=True, exist_ok=True)
    sheet.save(folder / f"{verdict.seed}-{number}.jpg", quality=85)


def _outlined(frame: Frame, numbers: Sequence[int]) -> Image.Image:
    assert frame.rgb is not None and frame.labels is not None
    pixels: Array = frame.rgb.copy()
    for number in numbers:
        mask = frame.labels == number
        pixels[ndimage.binary_dilation(mask, iterations=_LINE_PX) & ~mask] = _RED
    return Image.fromarray(pixels).resize((_SIDE, _SIDE))
