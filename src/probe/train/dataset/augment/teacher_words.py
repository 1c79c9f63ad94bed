"""What the scripted teacher says: which phrases its words are, and of which sides they speak."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import lru_cache

from probe.agents.phrases import phrases
from probe.train.dataset.augment.certain import has_sides
from probe.train.dataset.augment.slots import pattern_of

MIRRORED_DIRECTION = {"left": "right", "right": "left", "up": "up", "down": "down"}
"""Directions of pushes in a mirrored picture."""

_DIRECTION = "direction"
_AS_THEY_ARE = (_DIRECTION, "place", "size_one", "size_two", "long_one", "long_two")
"""Slots that need no look: a direction and a mark's place are mirrored, sizes are the same in a
mirror."""


def by_id(text: str) -> str:
    """A phrase whose slot {thing} an object_id fills, or such a phrase once it is filled."""
    return re.sub(r"\b[Tt]he (?=object_\d|{thing})", "", text)


def mirrored_words(words: str, direction: str | None = None) -> str | None:
    """What the teacher says in a mirrored episode.

    Args:
        words: What it says along with a call.
        direction: Of the call, if it is a push.

    Returns:
        None if the words aren't the scripted teacher's, or name a side that isn't the push's.
    """
    if not words or _are_neutral(words):
        return words
    for pattern in _patterns():
        if _DIRECTION not in pattern.groupindex or not (found := pattern.fullmatch(words)):
            continue
        if found[_DIRECTION] == direction and not has_sides(_slots(found)):
            start, end = found.span(_DIRECTION)
            return f"{words[:start]}{MIRRORED_DIRECTION[found[_DIRECTION]]}{words[end:]}"
    return None


def are_the_teachers(words: str) -> bool:
    """Whether words are phrases of the scripted teacher, or none."""
    return not words or _parts(words, _is_phrase)


def _are_neutral(words: str) -> bool:
    """Whether words are phrases that speak of no side."""
    return _parts(words, _is_neutral)


def _parts(words: str, fits: Callable[[str], bool]) -> bool:
    """Whether words are parts, each of one or more sentences, that fit one after another."""
    sentences = re.split(r"(?<=[.!?]) ", words)
    most = _most_sentences()
    begins = {0}  # before which sentences all parts so far end
    for end in range(1, len(sentences) + 1):
        some = (begin for begin in range(max(0, end - most), end) if begin in begins)
        if any(fits(" ".join(sentences[begin:end])) for begin in some):
            begins.add(end)
    return len(sentences) in begins


@lru_cache(1)
def _most_sentences() -> int:
    """Of any phrase; a name in it may end like a sentence, which makes two more."""
    longest = max(len(re.findall(r"[.!?]", text)) for some in phrases().values() for text in some)
    return longest + 2


def _is_phrase(text: str) -> bool:
    return any(pattern.fullmatch(text) for pattern in _patterns())


def _is_neutral(text: str) -> bool:
    return any(
        _DIRECTION not in pattern.groupindex and not has_sides(_slots(found))
        for pattern in _patterns()
        if (found := pattern.fullmatch(text))
    )


def _slots(found: re.Match[str]) -> str:
    """All that fills a phrase's slots and may speak of a side."""
    slots = found.groupdict().items()
    return "\n".join(text for slot, text in slots if slot not in _AS_THEY_ARE)


@lru_cache(1)
def _patterns() -> tuple[re.Pattern[str], ...]:
    sides = {_DIRECTION: MIRRORED_DIRECTION}
    texts = (text for some in phrases().values() for text in some)
    # An object_id stands without an article.
    both = dict.fromkeys(form for text in texts for form in (text, by_id(text)))
    return tuple(re.compile(pattern_of(text, sides)) for text in both)
