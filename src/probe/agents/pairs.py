"""How the scripted agent compares two marked things: it uncovers each and judges what it reads."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence

import numpy as np

from probe.agents.clearing import Search
from probe.agents.marks import Both, uncover_both
from probe.agents.moves import Plan, Way, answer
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
    question: Question, form: str, first: Way, rng: np.random.Generator, *, bold: bool = False
) -> Plan[None]:
    """Uncover both marked things and go by the boxes that they then have."""
    search = Search(lambda seen: False, first, rng)
    yield from search.begin()
    one, other = yield from uncover_both(question, search, bold=bold)
    if one is not None and other is not None:
        a, b = (_length(seen) if form == "longer" else seen.area for seen in (one, other))
        yield from answer("A" if (a > b) != (form == "smaller") else "B")
    elif bold:
        yield from answer(_either(rng))


def compare(
    question: Question,
    form: str,
    subject: str,
    first: Way,
    rng: np.random.Generator,
    *,
    bold: bool = False,
) -> Plan[None]:
    """Uncover both marked things and go by the colours that their descriptions name first."""
    search = Search(lambda seen: False, first, rng)
    yield from search.begin()
    like = search.graph.called(subject) if form == "like" else ()
    wanted = (_colours(like[0])[:1] if like else []) if form == "like" else _words(subject)[-1:]
    letter: str | None = None
    if wanted or form == "darker":
        both = yield from uncover_both(question, search, bold=bold)
        letter = _fitting(form, wanted, both) if bold or all(both) else None
    if letter or bold:
        yield from answer(letter or _either(rng))


def _fitting(form: str, wanted: Sequence[str], both: Both) -> str | None:
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


def _either(rng: np.random.Generator) -> str:
    return "AB"[int(rng.integers(2))]


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
