"""The point that a model's words give, whichever way it writes points down. Knows no pictures."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from itertools import islice
from typing import Literal, TypeGuard, cast

from probe.asking import UnusableReply

Convention = Literal["pixels", "xy1000", "yx1000", "xy100"]
"""How a model counts: (u, v) in pixels; x, y or y, x (Gemini) from 0 to 1000 over the whole
picture; x, y in percent (Molmo). Coordinates that are named x and y keep their names' order."""

IN_WORDS: dict[Convention, str] = {
    "pixels": "[x, y] in pixels from the top left corner",
    "xy1000": "[x, y], each from 0 to 1000 across the whole picture from the top left corner",
    "yx1000": "[y, x], each from 0 to 1000 across the whole picture from the top left corner",
    "xy100": "[x, y], each in percent of the whole picture from the top left corner",
}
"""How a model is told which one is meant."""

_WHOLE: dict[Convention, float] = {"xy1000": 1000.0, "yx1000": 1000.0, "xy100": 100.0}

_NUMBER = r"(-?\d{1,6}(?:\.\d{1,9})?)"
_BARE = re.compile(rf"\(\s*{_NUMBER}\s*,\s*{_NUMBER}\s*\)")
_TAGGED = re.compile(
    rf"<point[^<>]{{0,80}}>\s*[(\[]?\s*{_NUMBER}\s*[,\s]\s*{_NUMBER}\s*[)\]]?\s*</"
)
_NAMED = re.compile(rf"\bx1?\s*[=:]\s*\"?{_NUMBER}\"?[\s,;]{{0,3}}\by1?\s*[=:]\s*\"?{_NUMBER}")
_NOTHING = re.compile(
    r"\b(?:none|null|nothing|no such|cannot|can't)\b"
    r"|(?:\bnot|n't) (?:\w+ )?(?:visible|present|found|there|shown|see|find)\b",
    re.IGNORECASE,
)
_OPENING = re.compile(r"[{\[]")
_LARGEST = 1e9
_NAMES = (("x", "y"), ("u", "v"))

Said = tuple[float, float, bool] | None
"""Two numbers, and whether they were named x and y; None for "there is nothing"."""


def read_point(
    reply: str, convention: Convention, width_px: int, height_px: int
) -> tuple[int, int] | None:
    """The pixel (u, v) that a reply ends up with.

    It may be JSON, a tag or a pair in parentheses, with prose around it; what comes last counts,
    and of several points in one list the first. Of a box it is the middle.

    Returns:
        None if the reply says that there is nothing to point at.

    Raises:
        UnusableReply: It holds no point, or one outside the picture.
    """
    said = sorted(_said(reply), key=lambda found: found[0])
    if not said:
        if not reply.strip() or not _NOTHING.search(reply):
            raise UnusableReply("there is no point in it")
        return None
    last = said[-1][1]
    if last is None:
        return None
    first, second, named = last
    x, y = (first, second) if named or convention != "yx1000" else (second, first)
    return to_pixel(x, y, convention, width_px, height_px)


def to_pixel(
    x: float, y: float, convention: Convention, width_px: int, height_px: int
) -> tuple[int, int]:
    """The pixel (u, v) of coordinates across and down, in a convention's units.

    Raises:
        UnusableReply: It lies outside the picture.
    """
    whole = _WHOLE.get(convention)
    inside = (
        0 <= x <= whole and 0 <= y <= whole if whole else 0 <= x < width_px and 0 <= y < height_px
    )
    if not inside:
        units = "in pixels" if whole is None else f"from 0 to {whole:g}"
        raise UnusableReply(f"the point x {x:g}, y {y:g} ({units}) lies outside the picture")
    u, v = (x * width_px / whole, y * height_px / whole) if whole else (x, y)
    # The far edge of a normalised picture still means its last pixel.
    return min(int(u), width_px - 1), min(int(v), height_px - 1)


def _said(reply: str) -> Iterator[tuple[int, Said]]:
    """Everything in a reply that gives a point or says there is none, with where it stands."""
    taken: list[tuple[int, int]] = []
    for start, stop, value in _documents(reply):
        for found in islice(_within(value), 1):
            taken.append((start, stop))
            yield start, found
    for pattern in (_BARE, _TAGGED, _NAMED):
        for match in pattern.finditer(reply):
            if not any(start <= match.start() < stop for start, stop in taken):
                yield match.start(), (float(match[1]), float(match[2]), pattern is _NAMED)


def _documents(reply: str) -> Iterator[tuple[int, int, object]]:
    """All JSON objects and lists in a text that lie in no other, with their places."""
    decoder, at = json.JSONDecoder(), 0
    while opening := _OPENING.search(reply, at):
        at = opening.end()
        try:
            value, at = decoder.raw_decode(reply, opening.start())
        except ValueError:
            continue
        except RecursionError:  # thousands of brackets; trying each of them would take seconds
            return
        yield opening.start(), at, value


def _within(value: object) -> Iterator[Said]:
    """All points in a JSON value, in their order; None where it says that there is none."""
    if isinstance(value, dict):
        yield from _in_object(cast("dict[str, object]", value))
    elif isinstance(value, list):
        items = cast("list[object]", value)
        numbers = [item for item in items if _is_number(item)]
        if not items:
            yield None
        elif len(numbers) == len(items) and len(items) in (2, 4):
            yield (numbers[0] + numbers[-2]) / 2, (numbers[1] + numbers[-1]) / 2, False
        else:
            for item in items:
                yield from _within(item)


def _in_object(value: dict[str, object]) -> Iterator[Said]:
    for names in _NAMES:
        across, down = (value.get(name) for name in names)
        if _is_number(across) and _is_number(down):
            yield float(across), float(down), True
    if any(key.startswith("point") and not inner for key, inner in value.items()):
        yield None
    for inner in value.values():
        yield from _within(inner)


def _is_number(value: object) -> TypeGuard[int | float]:
    return isinstance(value, int | float) and not isinstance(value, bool) and abs(value) < _LARGEST
