"""The answer at the end of a reply in words. Knows no tools."""

from __future__ import annotations

import re

from probe.chat.coordinates import place_meant
from probe.episodes.seat import Points
from probe.tasks.task import LETTERS
from probe.toolshed.result import Answer

_NUMBER = r"(-?\d{1,6}(?:\.\d{1,9})?)"
_ANSWER = re.compile(
    rf"^[ \t*_#>`]*ANSWER[ *_`]*:[ \t*_`(]*([{''.join(LETTERS)}])\b[ \t*_`).]*"
    rf"(?:[(\[]\s*{_NUMBER}\s*,\s*{_NUMBER}\s*[)\]])?",
    re.IGNORECASE | re.MULTILINE,
)


def read_answer(reply: str, points: Points, letters: str = "".join(LETTERS)) -> Answer | None:
    """The answer of the last line "ANSWER: X" or "ANSWER: X (u, v)"; its point is in pixels.

    Emphasis around it (`**ANSWER: B**`) doesn't matter, nor case.

    Args:
        reply: What a model said.
        points: How it counts places.
        letters: Of the options; other letters are no answer.

    Returns:
        None if there is no such line.
    """
    found = list(_ANSWER.finditer(reply))
    if not found or found[-1][1].upper() not in letters:
        return None
    last = found[-1]
    point = (float(last[2]), float(last[3])) if last[2] is not None else None
    return Answer(last[1].upper(), point and place_meant(point, points))
