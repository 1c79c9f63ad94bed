"""How the scripted agent goes about each type of question; it answers on evidence or not at all."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from probe.agents.clearing import Search
from probe.agents.moves import Plan, Way, answer, none_of_them
from probe.agents.reading import Box, Graph, Seen, same
from probe.episodes.turns import Question

_MARGIN_PX = 40
"""What lay beneath a cover may have been dragged so far when that was lifted."""


def uncover(
    question: Question,
    names: Sequence[str],
    first: Way,
    rng: np.random.Generator,
    *,
    bold: bool = False,
) -> Plan[None]:
    """Clear away all that is named, then what lies there still, and name what comes to light."""
    search = Search(lambda seen: False, first, rng)
    yield from search.begin()
    known = {seen.name for seen in search.graph.named}
    place = _around([seen.box for name in names for seen in search.graph.called(name)])
    letter: str | None = None
    while place is not None:
        left = [seen for name in names for seen in search.graph.called(name)]
        fresh = [seen for seen in left if search.may_clear(seen)]
        # Pushed, a cover takes along what is beneath: that is where it went.
        place = _around([place, *(seen.box for seen in left)]) or place
        if not fresh or len(names) == 1:
            letter = _uncovered(question, search.graph, known, place)
        if letter is not None:
            break
        if fresh:
            # What lies on top of the others goes first: it would drag them along.
            yield from search.clear(min(fresh, key=lambda seen: len(search.graph.over(seen))))
        elif not (yield from _clear_around(search, place, known)):
            break
    yield from _conclude(question, letter, search.rng, bold=bold)


def _conclude(
    question: Question, letter: str | None, rng: np.random.Generator, *, bold: bool
) -> Plan[None]:
    """Answer; without evidence by chance if bold, else not at all."""
    if letter is None and bold:
        letter = question.options[int(rng.integers(len(question.options)))][0]
    if letter is not None:
        yield from answer(letter)


def _around(boxes: Sequence[Box]) -> Box | None:
    """The box around all of some; None around none."""
    if not boxes:
        return None
    left, top, right, bottom = zip(*boxes, strict=True)
    return min(left), min(top), max(right), max(bottom)


def find(
    question: Question, first: Way, rng: np.random.Generator, *, bold: bool = False
) -> Plan[None]:
    """Clear things away until one of the options shows, and point at it."""
    options = [text for _, text in question.options]
    search = Search(lambda seen: any(same(seen.name or "", o) for o in options), first, rng)
    yield from search.begin()
    while not (shown := _shown_options(question, search.graph)) and not search.complete:
        if not (yield from search.clear_one()):
            break
    if shown:
        letter, seen = shown[0]
        yield from answer(letter, seen.point)
    elif (search.complete or bold) and (none := none_of_them(question)):
        yield from answer(none)


def count(
    question: Question, name: str, first: Way, rng: np.random.Generator, *, bold: bool = False
) -> Plan[None]:
    """Clear away all else that could hide one, keep those that count, and take the most seen."""
    search = Search(lambda seen: same(seen.name or "", name), first, rng)
    yield from search.begin()
    most, now, gone = 0, len(search.graph.called(name)), 0
    while True:
        most = max(most, now + gone)
        before = now
        if search.complete or not (yield from search.clear_one()):
            break
        now = len(search.graph.called(name))
        if search.removed_last:
            # What lay on the thing or in it went along.
            gone += max(0, before - now)
    if search.complete or bold:
        letters = [letter for letter, text in question.options if text.strip() == str(most)]
        yield from _conclude(
            question, letters[0] if letters else none_of_them(question), rng, bold=bold
        )


def _shown_options(question: Question, graph: Graph) -> list[tuple[str, Seen]]:
    return [(letter, seen) for letter, text in question.options for seen in graph.called(text)]


def _uncovered(question: Question, graph: Graph, known: set[str | None], place: Box) -> str | None:
    """Letter of what came to light in a place; None as long as that isn't clear."""
    here = [s for s in graph.objects if _inside(s.point, place)]
    new = [s.name for s in here if s.name is not None and s.name not in known]
    letters = {letter for letter, text in question.options for n in new if same(n, text)}
    if len(letters) == 1:
        return letters.pop()
    half_hidden = any(s.name is None for s in here)
    return none_of_them(question) if new and not letters and not half_hidden else None


def _clear_around(search: Search, place: Box, known: set[str | None]) -> Plan[bool]:
    """Move away the largest thing in a place that was already known; False if there is none."""
    here = [s for s in search.graph.named if _inside(s.point, place) and s.name in known]
    here = [seen for seen in here if search.may_clear(seen)]
    if not here:
        return False
    yield from search.clear(max(here, key=lambda seen: seen.area))
    return True


def _inside(point: tuple[int, int], box: Box) -> bool:
    left, top, right, bottom = box
    across = left - _MARGIN_PX <= point[0] <= right + _MARGIN_PX
    return across and top - _MARGIN_PX <= point[1] <= bottom + _MARGIN_PX
