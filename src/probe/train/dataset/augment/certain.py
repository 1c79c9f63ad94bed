"""What can be told of a text's sides with certainty. Knows no tools."""

from __future__ import annotations

import re

from probe.errors import ProbeError

_SIDES = re.compile(r"\b(?:left|right|(?:anti|counter)?-?clockwise|sideways|mirror)", re.IGNORECASE)
_PLACES = re.compile(r"[\[(]\s*-?[\d.]+\s*,")


class NotCertain(ProbeError):
    """An episode that can't be told otherwise without guessing.

    Attributes:
        task: Which one's.
        reason: Why, in a few words that many episodes share.
    """

    def __init__(self, task: str, reason: str) -> None:
        super().__init__(f"{task} is told in one way alone: {reason}.")
        self.task = task
        self.reason = reason


def has_sides(text: str) -> bool:
    """Whether a text has a word for a side, or a place as numbers in brackets."""
    return bool(_SIDES.search(text) or _PLACES.search(text))
