"""The answer at the end of a reply in words. Knows no tools."""

from __future__ import annotations

import re

from probe.episodes.participation import Points
from probe.tasks.task import LETTERS
from probe.toolshed.result import Answer
from probe.transcripts.coordinates import place_meant

_NUMBER = r"(-?\d{1,6}(?:\.\d{1,9})?)"
_NO_LETTER = r"(?!(?i:(?<=A)[ \t]+(?!at\b)[a-z]|[ \t]+or\b|[ \t]*/))"
"""What may not follow: a word after an article ("a red mug"), another choice."""

_ANSWER = re.compile(
    rf"^[ \t*_#>`]*ANSWER[ *_`]*:[ \t*_`(]*([{''.join(LETTERS)}])\b{_NO_LETTER}",
    re.IGNORECASE | re.MULTILINE,
)
_POINT = re.compile(
    rf"[(\[]\s*(?:[ux]\s*[=:]\s*)?{_NUMBER}\s*,\s*(?:[vy]\s*[=:]\s*)?{_NUMBER}\s*[)\]]",
    re.IGNORECASE,
)


def read_answer(reply: str, points: Points, letters: str = "".join(LETTERS)) -> Answer | None:
    """The answer of the last line "ANSWER: X" or "ANSWER: X (u, v)"; its point is in pixels.

    Emphasis around it (`**ANSWER: B**`) doesn't matter, nor case. The point is the first pair in
    brackets after the letter, whatever stands between them.

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
    place = _POINT.search(reply, last.end())
    point = place_meant((float(place[1]), float(place[2])), points) if place else None
    return Answer(last[1].upper(), point)
