"""The little English that questions need: plurals and lists of catalogue names."""

from __future__ import annotations

import re
from collections.abc import Sequence

_ALREADY_PLURAL = {"headphones", "marbles", "pliers", "scissors", "tongs", "tweezers"}
_ENDINGS = (
    (r"(kni|li|wi)fe$", r"\1ves"),
    (r"(loa|lea|shel|hal)f$", r"\1ves"),
    (r"(potat|tomat)o$", r"\1oes"),
    (r"mouse$", "mice"),
    (r"brush$", "brushes"),
    (r"^die$|(?<= )die$", "dice"),
    (r"foot$", "feet"),
    (r"([^aeiou])y$", r"\1ies"),
    (r"(s|x|z|ch|sh)$", r"\1es"),
)
_TAIL = re.compile(r" (?:of|with|without|for|in|on|to) ")


def plural(name: str) -> str | None:
    """Plural of a catalogue name ("box of tea" -> "boxes of tea").

    Returns:
        None where the name has no plural of its own ("scissors"): it can't be counted in words.
    """
    cut = _TAIL.search(name)
    head, tail = (name[: cut.start()], name[cut.start() :]) if cut else (name, "")
    if head.split()[-1] in _ALREADY_PLURAL:
        return None
    for pattern, ending in _ENDINGS:
        changed, count = re.subn(pattern, ending, head)
        if count:
            return changed + tail
    return head + "s" + tail


def listed(names: Sequence[str]) -> str:
    """Names with their articles as part of a sentence ("the red mug and the white plate")."""
    return joined([f"the {name}" for name in names])


def joined(parts: Sequence[str]) -> str:
    """One part or more as a list in a sentence ("one, two and three")."""
    *most, last = parts
    return f"{', '.join(most)} and {last}" if most else last
