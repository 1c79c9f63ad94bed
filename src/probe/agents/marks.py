"""Uncovers two marked things, and follows each from its mark to its name."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from probe.agents.clearing import Search
from probe.agents.moves import Plan, answer
from probe.agents.phrases import Reason, Say
from probe.agents.reading import Graph, Seen
from probe.agents.text_features import marks_in
from probe.agents.type_plan import FirstLookQuestion
from probe.episodes.turns import Question

Both = tuple[Seen | None, Seen | None]
"""A and B as they showed most of themselves; None for one that never had a name."""

_NEAR_PX = 60
_AT_PX = 8
"""A mark lies so near the point that lists tell of a thing; more, and it has moved."""
_MOST = 5
"""Manipulations for one of the two: with both, some of the ten are left."""


def _name(seen: Seen) -> str:
    return seen.name or ""


def uncover_both(
    question: Question, search: Search, *, bold: bool, call: Callable[[Seen], str] = _name
) -> Plan[Both]:
    """Both marked things as they show once nothing lies on them; None for one that doesn't.

    Args:
        question: Tells the marks.
        search: What is known of the table.
        bold: Whether to take what could be seen of them.
        call: What to call a marked thing that has a name.
    """
    marks = marks_of(question)
    search.remark(_at_the_marks(search, marks))
    crowd = {seen.name for seen in search.graph.named}
    # Those that are marked show too little to be named, or a little more.
    for mark in marks.values():
        here = at(search.graph.objects, mark)
        crowd -= {here.name if here else None}
    found: list[Seen | None] = []
    for letter, mark in marks.items():
        marked = _Marked(letter, mark, crowd, call)
        clear = yield from marked.uncover(search)
        if not clear and not bold:
            return None, None
        found.append(marked.shown)
        if marked.shown:
            crowd.add(marked.shown.name)
    return found[0], found[1]


def _at_the_marks(search: Search, marks: Mapping[str, tuple[int, int]]) -> str:
    """Which of the listed things the marks are on, where that is sure."""
    here = {letter: at(search.graph.objects, mark) for letter, mark in marks.items()}
    told = (
        search.say("mark at", {"letter": letter, "place": str(marks[letter]), "id": seen.object_id})
        for letter, seen in here.items()
        if seen is not None and seen.object_id and _is_marked(seen, marks[letter])
    )
    return " ".join(told)


def _is_marked(seen: Seen, mark: tuple[int, int]) -> bool:
    """Whether a mark is where a list tells of a thing; else it may be on another one there."""
    return math.dist(seen.point, mark) <= _AT_PX


def marks_of(question: Question) -> dict[str, tuple[int, int]]:
    """Pixels (u, v) of the marks, by letter, as the question tells them."""
    return dict(zip("AB", marks_in(question.text), strict=False))


def marked_at_sight(asked: FirstLookQuestion) -> Both:
    """What is marked A and B, as far as it can be named at first sight."""
    marks = marks_of(asked.question)
    found = [at(asked.graph.objects, marks[letter]) for letter in "AB"]
    one, two = (seen if seen is not None and seen.name is not None else None for seen in found)
    return one, two


def guess_mark(rng: np.random.Generator, say: Say) -> Plan[None]:
    """Answer A or B by chance."""
    letter = "AB"[int(rng.integers(2))]
    yield from answer(letter, words=say("guess", {"letter": letter}))


@dataclass
class _Marked:
    """A marked thing that is being uncovered; known by its mark, then by its name.

    Attributes:
        letter: Of the mark.
        mark: Pixel (u, v) on it in the first picture.
        crowd: Names of things that it isn't.
        call: What to call it once it has a name.
        here: Its entry in the last graph, if it shows.
        shown: Its largest entry so far that had a name.
        sure: Whether its entry is that of what is marked, and not of something much like it.
    """

    letter: str
    mark: tuple[int, int]
    crowd: set[str | None]
    call: Callable[[Seen], str]
    here: Seen | None = None
    shown: Seen | None = None
    sure: bool = False

    def uncover(self, search: Search) -> Plan[bool]:
        """Clear away what lies on it until nothing does; says whether that worked."""
        spent = search.spent
        self._follow(search.graph)
        self.sure = self.here is not None and _is_marked(self.here, self.mark)
        search.remark(self._told(search.say))
        while not self._is_clear(search.graph):
            over = self._over(search)
            if not over or search.spent - spent >= _MOST:
                return False
            chosen = max(over, key=lambda seen: seen.area)
            yield from search.clear(chosen, self._why(chosen, search.graph))
            before, named = self.here, self.shown is not None
            self._follow(search.graph)
            same = before and self.here and before.object_id == self.here.object_id
            self.sure = self.sure and (named or bool(same))
            search.remark(self._told(search.say))
        return True

    def _told(self, say: Say) -> str:
        """Which of the listed things it is; nothing of one that is neither named nor sure."""
        here = self.here
        if here is None or not here.object_id:
            return ""
        slots = {"letter": self.letter, "id": here.object_id}
        if not here.name:
            return say("marked unclear", slots) if self.sure else ""
        slots |= {"thing": self.call(here)}
        return say("marked" if self.sure else "marked perhaps", slots)

    def _follow(self, graph: Graph) -> None:
        """Find it in a new graph: by its name if that is known, else what is new by its mark."""
        name = self.shown.name if self.shown else None
        if name is None:
            fresh = [seen for seen in graph.objects if seen.name not in self.crowd]
            named = [seen for seen in fresh if seen.name is not None]
            self.here = at(fresh, self.mark) or (named[0] if len(named) == 1 else None)
        else:
            self.here = next(iter(graph.called(name)), None)
        now = self.here
        if now and now.name and (self.shown is None or now.area > self.shown.area):
            self.shown = now

    def _is_clear(self, graph: Graph) -> bool:
        here = self.here
        return here is not None and here.name is not None and not graph.over(here)

    def _why(self, seen: Seen, graph: Graph) -> Reason:
        if self.here is None:
            return Reason("mark place", letter=self.letter)
        occasion = "mark on" if seen.number in graph.over(self.here) else "mark touching"
        return Reason(occasion, letter=self.letter)

    def _over(self, search: Search) -> list[Seen]:
        """What lies on it, or else what touches it or is where its mark was."""
        movable = [seen for seen in search.graph.named if search.may_clear(seen)]
        if self.here is None:
            return [seen for seen in movable if _holds(seen, self.mark)]
        over, meeting = search.graph.over(self.here), search.graph.meeting(self.here)
        others = [seen for seen in movable if seen.number != self.here.number]
        lying = [seen for seen in others if seen.number in over]
        return lying or [seen for seen in others if seen.number in meeting]


def at(objects: Sequence[Seen], mark: tuple[int, int]) -> Seen | None:
    """The smallest thing whose box has a point in it, or else the one with the nearest point."""
    here = [seen for seen in objects if _holds(seen, mark)]
    if here:
        return min(here, key=lambda seen: seen.area)
    near = [seen for seen in objects if math.dist(seen.point, mark) < _NEAR_PX]
    return min(near, key=lambda seen: math.dist(seen.point, mark), default=None)


def _holds(seen: Seen, point: tuple[int, int]) -> bool:
    left, top, right, bottom = seen.box
    return left <= point[0] <= right and top <= point[1] <= bottom
