"""Replies of the tools, other than lists, as they would be of the mirrored picture. Texts alone."""

from __future__ import annotations

import re

from probe.toolshed.findings import NOTHING_ALIKE
from probe.train.dataset.augment.certain import has_sides
from probe.train.dataset.augment.mirrored_list import mirrored_box, mirrored_place
from probe.train.dataset.augment.teacher_words import MIRRORED_DIRECTION

_KNOWN = re.compile(
    r"\[(?P<place>\d+, \d+)\]|\[(?P<box>\d+, \d+, \d+, \d+)\]|"
    r"(?<=towards the )(?P<side>left|right)(?= of the picture)"
)
_NO_SIDE = re.compile(r"Manipulations left: |may have left the picture")
"""What tools say with words that are also names of sides."""

_OTHERS = (
    "Also in the basket now",
    "Shows in the basket, where it may have lain before",
    "Also moved",
    "May have moved",
    "Beside the basket",
    "Out of sight",
    "No longer to be seen",
    "Not found again",
)
_SENTENCE = re.compile(rf"\b(?:{'|'.join(_OTHERS)})[^:;\[\]]*: ")
_END = re.compile(r"\.(?: (?=[A-Z])|$)")
_NEW_ID = re.compile(r"\bobject_\d+ now\b")
_POINT = re.compile(r"\[\d+, (\d+)\]")


def mirrored_reply(text: str, side_px: int) -> str | None:
    """A reply of the mirrored picture; None if it speaks of sides in other words than tools do.

    Args:
        text: The reply; its object_ids stay.
        side_px: Width of the picture.
    """
    if text == NOTHING_ALIKE:  # its place is an example
        return text
    if has_sides(_NO_SIDE.sub("", _KNOWN.sub("", text))):
        return None

    def told(found: re.Match[str]) -> str:
        if side := found["side"]:
            return MIRRORED_DIRECTION[side]
        if found["place"]:
            u, v = map(int, found["place"].split(", "))
            return str(list(mirrored_place((u, v), side_px)))
        left, top, right, bottom = map(int, found["box"].split(", "))
        return str(list(mirrored_box((left, top, right, bottom), side_px)))

    return _KNOWN.sub(told, text)


def orders_level_things(found: str) -> bool:
    """Whether a reply of find_object names two things whose points are equally high.

    Which of them comes first may hang on which is further left.
    """
    heights = _POINT.findall(found)
    return len(set(heights)) < len(heights)


def orders_others(moved: str) -> bool:
    """Whether a reply to a grasp or a push tells several things in an order, or names them anew.

    The order is that of a look at the table, from top to bottom, then left to right.
    """
    told = _SENTENCE.split(moved)[1:]
    several = any("; " in part or "] and [" in part for part in told)
    return several or len(_NEW_ID.findall(moved)) > 1


def others_told(moved: str) -> list[str]:
    """What a reply to a grasp or a push says of each other thing: "red mug by about 5 cm"."""
    parts = [_END.split(part)[0] for part in _SENTENCE.split(moved)[1:]]
    return [each for part in parts for each in part.split("; ")]
