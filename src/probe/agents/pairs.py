"""How the scripted agent compares two marked things: it uncovers each and judges what it reads."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence

import numpy as np

from probe.agents.clearing import Search
from probe.agents.marks import Both, uncover_both
from probe.agents.moves import Plan, Way, answer
from probe.agents.phrases import Say, silent
from probe.agents.reading import Seen
from probe.episodes.turns import Question

_MIDDLE = 50
"""L* of what isn't known."""

# L* of what these words usually mean, rounded.
_LIGHTNESS = {
    "black": 10, "dark": 25, "brown": 35, "purple": 38, "blue": 40, "red": 45, "green": 48,
    "gray": 50, "grey": 50, "teal": 52, "gold": 65, "orange": 65, "tan": 70, "pink": 72,
    "silver": 72, "beige": 82, "yellow": 84, "light": 78, "cream": 90, "white": 95,
}  # fmt: skip


def size(
    question: Question,
    form: str,
    first: Way,
    rng: np.random.Generator,
    *,
    bold: bool = False,
    say: Say = silent,
) -> Plan[None]:
    """Uncover both marked things and go by the boxes that they then have."""
    search = Search(lambda seen: False, first, rng, say=say)
    yield from search.begin()
    one, other = yield from uncover_both(question, search, bold=bold)
    if one is not None and other is not None:
        letter = larger(form, one, other)
        slots = {"one": one.name or "", "two": other.name or "", "letter": letter}
        yield from answer(letter, words=say(f"size {form}", slots))
    elif bold:
        yield from _guess(rng, say)


def larger(form: str, one: Seen, other: Seen) -> str:
    """Letter of the longer, larger or smaller one, by their boxes."""
    a, b = (_length(seen) if form == "longer" else seen.area for seen in (one, other))
    return "A" if (a > b) != (form == "smaller") else "B"


def compare(
    question: Question,
    form: str,
    subject: str,
    first: Way,
    rng: np.random.Generator,
    *,
    bold: bool = False,
    say: Say = silent,
) -> Plan[None]:
    """Uncover both marked things and go by the colours that their descriptions name first."""
    search = Search(lambda seen: False, first, rng, say=say)
    yield from search.begin()
    like = search.graph.called(subject) if form == "like" else ()
    wanted = wanted_colour(form, subject, like)
    both: Both = (None, None)
    letter: str | None = None
    if wanted or form == "darker":
        both = yield from uncover_both(question, search, bold=bold)
        letter = fitting(form, wanted, both) if bold or all(both) else None
    if letter and all(both):
        one, two = (seen.name or "" for seen in both if seen)
        occasion = "compare darker" if form == "darker" else "compare colour"
        words = say(occasion, {"one": one, "two": two, "letter": letter})
        yield from answer(letter, words=words)
    elif letter:
        yield from answer(letter, words=say("guess", {"letter": letter}))
    elif bold:
        yield from _guess(rng, say)


def wanted_colour(form: str, subject: str, like: Sequence[Seen]) -> list[str]:
    """The word of the colour that is asked for; none if that isn't known.

    Args:
        form: What exactly is asked.
        subject: The colour itself, or the thing that has it.
        like: What goes by that thing's name.
    """
    if form == "like":
        return _colours(like[0])[:1] if like else []
    return _words(subject)[-1:]


def fitting(form: str, wanted: Sequence[str], both: Both) -> str | None:
    """Letter of the one whose colour is asked for; None if that can't be told.

    Of one alone it goes by what it is: only one of the two has the colour.
    """
    a, b = (_colours(seen)[:1] if seen else [] for seen in both)
    if form == "darker":
        light = [_LIGHTNESS[words[0]] if words else _MIDDLE for words in (a, b)]
        fits = [light[0] < light[1], light[1] < light[0]]
    else:
        fits = [bool(words) and words[0] == wanted[0] for words in (a, b)]
        # One that is known not to have it leaves the other.
        fits = fits if any(fits) else [bool(b), bool(a)]
    return None if fits[0] == fits[1] else "A" if fits[0] else "B"


def _guess(rng: np.random.Generator, say: Say) -> Plan[None]:
    letter = "AB"[int(rng.integers(2))]
    yield from answer(letter, words=say("guess", {"letter": letter}))


def _length(seen: Seen) -> float:
    """Its longest side in pixels, as far as a box tells: the diagonal, for what lies askew."""
    left, top, right, bottom = seen.box
    return math.hypot(right - left, bottom - top)


def _colours(seen: Seen) -> list[str]:
    return _words(f"{seen.name or ''} {seen.description}")


def _words(text: str) -> list[str]:
    """Colour words in the order in which a text names them; "dark" and "light" are shades."""
    found = [word for word in re.findall(r"[a-z]+", text.lower()) if word in _LIGHTNESS]
    plain = [word for word in found if word not in ("dark", "light")]
    return plain or found
