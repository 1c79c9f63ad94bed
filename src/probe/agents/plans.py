"""How the scripted agent goes about each type of question; it answers on evidence or not at all."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from probe.agents.clearing import Search
from probe.agents.moves import Plan, Way, answer, none_of_them
from probe.agents.phrases import Reason, Say, silent
from probe.agents.reading import Box, Graph, Seen, same
from probe.episodes.turns import Question

_MARGIN_PX = 40
"""What lay beneath a cover may have been dragged so far when that was lifted."""


def uncover(
    question: Question,
    names: Sequence[str],
    why: Reason,
    first: Way,
    rng: np.random.Generator,
    *,
    bold: bool = False,
    say: Say = silent,
) -> Plan[None]:
    """Clear away all that is named, then what lies there still, and name what comes to light."""
    search = Search(lambda seen: False, first, rng, say=say)
    yield from search.begin()
    known = {seen.name for seen in search.graph.named}
    place = _around([seen.box for name in names for seen in search.graph.called(name)])
    found: _Found | None = None
    while place is not None:
        left = [seen for name in names for seen in search.graph.called(name)]
        fresh = [seen for seen in left if search.may_clear(seen)]
        # Pushed, a cover takes along what is beneath: that is where it went.
        place = _around([place, *(seen.box for seen in left)]) or place
        if not fresh or len(names) == 1:
            found = _uncovered(question, search.graph, known, place)
        if found is not None:
            break
        if fresh:
            # What lies on top of the others goes first: it would drag them along.
            highest = min(fresh, key=lambda seen: len(search.graph.over(seen)))
            yield from search.clear(highest, why)
        elif not (yield from _clear_around(search, place, known)):
            break
    yield from _conclude(question, found, search, bold=bold)


@dataclass(frozen=True)
class _Found:
    """A letter, and the occasion to say how it came, with what fills the phrase's slots."""

    letter: str
    occasion: str
    slots: Mapping[str, str]


def _conclude(
    question: Question, found: _Found | None, search: Search, *, bold: bool
) -> Plan[None]:
    """Answer; without evidence by chance if bold, else not at all."""
    if found is None and bold:
        options = question.options
        found = _Found(options[int(search.rng.integers(len(options)))][0], "guess", {})
    if found is not None:
        words = search.say(found.occasion, {"letter": found.letter, **found.slots})
        yield from answer(found.letter, words=words)


def _around(boxes: Sequence[Box]) -> Box | None:
    """The box around all of some; None around none."""
    if not boxes:
        return None
    left, top, right, bottom = zip(*boxes, strict=True)
    return min(left), min(top), max(right), max(bottom)


def find(
    question: Question,
    first: Way,
    rng: np.random.Generator,
    *,
    bold: bool = False,
    say: Say = silent,
) -> Plan[None]:
    """Clear things away until one of the options shows, and point at it."""
    options = [text for _, text in question.options]
    search = Search(
        lambda seen: any(same(seen.name or "", o) for o in options), first, rng, say=say
    )
    yield from search.begin()
    while not (shown := _shown_options(question, search.graph)) and not search.complete:
        if not (yield from search.clear_one()):
            break
    if shown:
        letter, seen = shown[0]
        words = say("find", {"thing": seen.name or "", "letter": letter})
        yield from answer(letter, seen.point, words)
    elif (search.complete or bold) and (none := none_of_them(question)):
        words = say("find none" if search.complete else "guess", {"letter": none})
        yield from answer(none, words=words)


def count(
    question: Question,
    name: str,
    first: Way,
    rng: np.random.Generator,
    *,
    bold: bool = False,
    say: Say = silent,
) -> Plan[None]:
    """Clear away all else that could hide one, keep those that count, and take the most seen."""
    search = Search(lambda seen: same(seen.name or "", name), first, rng, say=say)
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
        found = _counted(question, most, sure=search.complete)
        yield from _conclude(question, found, search, bold=bold)


def _shown_options(question: Question, graph: Graph) -> list[tuple[str, Seen]]:
    return [(letter, seen) for letter, text in question.options for seen in graph.called(text)]


def _counted(question: Question, most: int, *, sure: bool) -> _Found | None:
    """The letter of a number, or else that of none of them."""
    letters = [letter for letter, text in question.options if text.strip() == str(most)]
    letter = letters[0] if letters else none_of_them(question)
    if letter is None:
        return None
    occasion = "guess" if not sure else "count" if letters else "count none"
    return _Found(letter, occasion, {"number": str(most)})


def _uncovered(
    question: Question, graph: Graph, known: set[str | None], place: Box
) -> _Found | None:
    """Letter of what came to light in a place; None as long as that isn't clear."""
    here = [s for s in graph.objects if _inside(s.point, place)]
    new = [s.name for s in here if s.name is not None and s.name not in known]
    letters = {letter: n for letter, text in question.options for n in new if same(n, text)}
    if len(letters) == 1:
        ((letter, name),) = letters.items()
        return _Found(letter, "came out", {"thing": name})
    half_hidden = any(s.name is None for s in here)
    none = none_of_them(question)
    if none is None or not new or letters or half_hidden:
        return None
    return _Found(none, "came out none", {"thing": new[0]})


def _clear_around(search: Search, place: Box, known: set[str | None]) -> Plan[bool]:
    """Move away the largest thing in a place that was already known; False if there is none."""
    here = [s for s in search.graph.named if _inside(s.point, place) and s.name in known]
    here = [seen for seen in here if search.may_clear(seen)]
    if not here:
        return False
    yield from search.clear(max(here, key=lambda seen: seen.area), Reason("place"))
    return True


def _inside(point: tuple[int, int], box: Box) -> bool:
    left, top, right, bottom = box
    across = left - _MARGIN_PX <= point[0] <= right + _MARGIN_PX
    return across and top - _MARGIN_PX <= point[1] <= bottom + _MARGIN_PX
