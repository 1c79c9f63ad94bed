"""Texts with slots, such as wordings and phrases, as patterns that find what fills the slots."""

from __future__ import annotations

import re
import string
from collections.abc import Iterable, Iterator, Mapping


def pattern_of(text: str, choices: Mapping[str, Iterable[str]] | None = None) -> str:
    """A regular expression that a filled text matches, with a group of each slot's name.

    Args:
        text: With slots as str.format() takes them; one that comes again is filled the same way.
        choices: What alone may fill a slot, by its name; anything fills the others.
    """
    return "".join(_pieces(text, choices or {}))


def _pieces(text: str, choices: Mapping[str, Iterable[str]]) -> Iterator[str]:
    known: set[str] = set()
    for literal, slot, _, _ in string.Formatter().parse(text):
        yield re.escape(literal)
        if slot is None:
            continue
        if slot in known:
            yield f"(?P={slot})"
        else:
            yield f"(?P<{slot}>{'|'.join(choices[slot]) if slot in choices else '.+?'})"
        known.add(slot)
