"""Places in a picture as a model counts them, and back to pixels. Texts and calls; no pictures."""

from __future__ import annotations

import json
import re
from typing import Any, TypeGuard, cast

from probe.episodes.participation import Points
from probe.episodes.turns import Call
from probe.errors import BadData
from probe.types import USUAL_SCALE, PictureScale


def in_words(points: Points, side_px: int) -> str:
    """How a model is told which way of counting is meant, of pictures with this edge."""
    if points == "pixels":
        return (
            f"in pixels from the top left corner of the picture, which is {side_px} wide and high"
        )
    return (
        "in thousandths of the picture's width and height from its top left corner, each "
        "from 0 to 1000"
    )


def check_countable(points: Points, scale: PictureScale) -> None:
    """Refuse places in thousandths of pictures that haven't the usual size.

    Raises:
        BadData: They would come out wrong.
    """
    if points != "pixels" and scale.side_px != _SIDE_PX:
        reason = f"thousandths are of {_SIDE_PX} pixels, and the set-up's pictures have "
        raise BadData("--points", f"{reason}{scale.side_px}", "Count in pixels")


_SIDE_PX = USUAL_SCALE.side_px
_WHOLE = 1000.0
_LAST_PX = _SIDE_PX - 0.001
"""The far edge of a picture, counted in thousandths, still means its last pixel."""

_MOST_PX = 1e6
"""Larger numbers, endless ones among them, are no place, and are left to the tools to refuse."""

_NUMBER = r"-?\d{1,6}(?:\.\d{1,6})?"
_PLACE = re.compile(rf"([(\[]\s*)({_NUMBER}(?:\s*,\s*{_NUMBER}){{1,3}})(?=\s*[)\]])")
_NUMBERS = re.compile(_NUMBER)
_AT = re.compile(rf"(\bat\s+)({_NUMBER}\s*,\s*{_NUMBER})")


def told(text: str, points: Points) -> str:
    """A text with places in pixels (of a tool, a question, a schema) as a model reads it.

    Places are numbers in brackets, two or four of them.
    """
    if points == "pixels":
        return text
    counted = _scaled(text, _WHOLE / _SIDE_PX, digits=0)
    counted = counted.replace("in pixels", "in thousandths of the picture's width and height")
    return counted.replace(f"less than {_SIDE_PX}", f"at most {_WHOLE:.0f}")


def meant(call: Call, points: Points) -> Call:
    """A model's call with its places in pixels; one that fits no tool is left as it is."""
    return call if points == "pixels" else _converted(call, _SIDE_PX / _WHOLE, 3)


def as_said(call: Call, points: Points) -> Call:
    """A recorded call as its model made it: what meant() did, undone."""
    return call if points == "pixels" else _converted(call, _WHOLE / _SIDE_PX, 2)


def as_whole(call: Call, points: Points) -> Call:
    """A call whose places are whole numbers in the way in which an agent counts them."""
    if points == "pixels":
        return call
    return meant(_converted(call, _WHOLE / _SIDE_PX, 0), points)


def place_meant(point: tuple[float, float], points: Points) -> tuple[float, float]:
    """A place that a model wrote down, in pixels."""
    if points == "pixels":
        return point
    u, v = (_tidy(_pixel(number * _SIDE_PX / _WHOLE), 3) for number in point)
    return float(u), float(v)


def _converted(call: Call, factor: float, digits: int) -> Call:
    values = call.values
    if not isinstance(values, dict):
        return call
    said = dict(cast("dict[str, Any]", values))
    description, point = said.get("description"), said.get("point")
    if call.name == "find_object" and isinstance(description, str):
        said["description"] = _scaled(description, factor, digits)
    elif call.name == "answer_question" and _is_place(point):
        said["point"] = [_tidy(_clipped(number * factor, factor), digits) for number in point]
    else:
        return call
    return Call.of(call.name, said, call.words)


def _is_place(value: object) -> TypeGuard[list[float]]:
    if not isinstance(value, list):
        return False
    numbers = cast("list[object]", value)
    return len(numbers) == 2 and all(
        isinstance(number, int | float)
        and not isinstance(number, bool)
        and -_MOST_PX <= number <= _MOST_PX
        for number in numbers
    )


def _scaled(text: str, factor: float, digits: int) -> str:
    def scale(match: re.Match[str]) -> str:
        if len(_NUMBERS.findall(match[2])) == 3:
            return match[0]
        return match[1] + _NUMBERS.sub(
            lambda n: json.dumps(_tidy(_clipped(float(n[0]) * factor, factor), digits)), match[2]
        )

    found = _PLACE.sub(scale, text)
    # Free words may name a place without brackets, too.
    return _AT.sub(scale, found) if digits else found


def _clipped(number: float, factor: float) -> float:
    """Keep the far edge, in pixels, inside the picture."""
    return _pixel(number) if factor > 1 else number


def _pixel(number: float) -> float:
    return _LAST_PX if number == _SIDE_PX else number


def _tidy(number: float, digits: int) -> float | int:
    """Rounded, and without a fraction where there is none."""
    short = round(number, digits)
    return int(short) if short == int(short) else short
