"""How the scripted agent compares two marked things: it uncovers each and judges what it reads."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence

import numpy as np

from probe.agents.clearing import Search
from probe.agents.moves import Plan, Way, answer
from probe.agents.reading import Seen
from probe.episodes.turns import Question

_MARK = re.compile(r"\b([AB]) at \((\d+), (\d+)\)")
_NEAR_PX = 60
_MOST = 4
"""Manipulations for one of the two: with both, some of the ten are left."""

# L* of what these words usually mean, rounded.
_LIGHTNESS = {
    "black": 10, "dark": 25, "brown": 35, "purple": 38, "blue": 40, "red": 45, "green": 48,
    "gray": 50, "grey": 50, "teal": 52, "gold": 65, "orange": 65, "tan": 70, "pink": 72,
    "silver": 72, "beige": 82, "yellow": 84, "light": 78, "cream": 90, "white": 95,
}  # fmt: skip


def size(question: Question, form: str, first: Way, rng: np.random.Generator) -> Plan[None]:
    """Uncover both marked things and go by the boxes that they then have."""
    both = yield from _uncovered(question, first, rng)
    if both is None:
        return
    a, b = (_length(seen) if form == "longer" else seen.area for seen in both)
    yield from answer("A" if (a > b) != (form == "smaller") else "B")


def compare(
    question: Question, form: str, subject: str, first: Way, rng: np.random.Generator
) -> Plan[None]:
    """Uncover both marked things and go by the colours that their descriptions name first."""
    search = Search(lambda seen: False, first, rng)
    yield from search.begin()
    like = search.graph.called(subject) if form == "like" else ()
    if form == "like" and not like:
        return
    both = yield from _uncovered(question, first, rng)
    if both is None:
        return
    a, b = (_colours(seen) for seen in both)
    if not a or not b:
        return
    if form == "darker":
        yield from answer("A" if _LIGHTNESS[a[0]] < _LIGHTNESS[b[0]] else "B")
        return
    wanted = _colours(like[0])[:1] if like else _words(subject)[-1:]
    if wanted and (a[0] == wanted[0]) != (b[0] == wanted[0]):
        yield from answer("A" if a[0] == wanted[0] else "B")


def _uncovered(
    question: Question, first: Way, rng: np.random.Generator
) -> Plan[tuple[Seen, Seen] | None]:
    """Both marked things as they show once nothing lies on them; None if that can't be had."""
    marks = {letter: (int(u), int(v)) for letter, u, v in _MARK.findall(question.text)}
    search = Search(lambda seen: False, first, rng)
    yield from search.begin()
    a = yield from _uncover(search, marks["A"])
    b = yield from _uncover(search, marks["B"])
    return (a, b) if a and b else None


def _uncover(search: Search, mark: tuple[int, int]) -> Plan[Seen | None]:
    """Clear away what lies on the thing at a mark until it is named and nothing covers it."""
    spent = search.spent
    while True:
        marked = _at(search.graph.objects, mark)
        if marked is None:
            return None
        over = [
            seen
            for seen in search.graph.named
            if seen.number in search.graph.over(marked) and seen.number != marked.number
        ]
        if marked.name is not None and not over:
            return marked
        nearby = over or [
            seen
            for seen in search.graph.named
            if seen.number in search.graph.meeting(marked) and seen.number != marked.number
        ]
        if not nearby or search.spent - spent >= _MOST:
            return None
        yield from search.clear(max(nearby, key=lambda seen: seen.area))


def _at(objects: Sequence[Seen], mark: tuple[int, int]) -> Seen | None:
    """The smallest thing whose box has a point in it, or else the one with the nearest point."""
    here = [seen for seen in objects if _holds(seen, mark)]
    if here:
        return min(here, key=lambda seen: seen.area)
    near = [seen for seen in objects if math.dist(seen.point, mark) < _NEAR_PX]
    return min(near, key=lambda seen: math.dist(seen.point, mark), default=None)


def _holds(seen: Seen, point: tuple[int, int]) -> bool:
    left, top, right, bottom = seen.box
    return left <= point[0] <= right and top <= point[1] <= bottom


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
