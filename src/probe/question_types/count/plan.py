"""How the scripted agent goes about Count: it searches everywhere and takes the most it saw."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from probe.agents.clearing import Search
from probe.agents.moves import Plan, none_of_them
from probe.agents.phrases import Say
from probe.agents.reading import Graph, Seen, same
from probe.agents.type_plan import FirstLookAnswer, FirstLookQuestion, ScriptedQuestion, TypePlan
from probe.agents.uncovering import FoundAnswer, conclude
from probe.episodes.turns import Question
from probe.tasks.english import joined

_UNNAMED = "without a name"
"""What shows too little."""
_Listed = frozenset[tuple[str, str | None]]
"""object_ids with names."""


@dataclass(frozen=True)
class _Tally:
    """Those that show at one time, and how many had left the table by then.

    Attributes:
        shown: Those that were told of before come first.
        gone: How many aren't on the table any more.
    """

    shown: Sequence[Seen] = ()
    gone: int = 0

    def after(self, shown: Sequence[Seen], *, removed: bool) -> _Tally:
        """The next one.

        Args:
            shown: Those that show now.
            removed: Whether something was taken off the table since; what lay on it went along.
        """
        lost = max(0, len(self.shown) - len(shown)) if removed else 0
        order = {seen.object_id: number for number, seen in enumerate(self.shown)}
        kept = sorted(shown, key=lambda seen: order.get(seen.object_id, len(order)))
        return _Tally(kept, self.gone + lost)

    @property
    def number(self) -> int:
        """How many these are."""
        return len(self.shown) + self.gone

    @property
    def each(self) -> list[str]:
        """What to call each of them."""
        shown = [seen.object_id or seen.place for seen in self.shown]
        return [*shown, f"{self.gone} that went along with what I lifted"] if self.gone else shown

    def told(self, name: str, say: Say) -> str:
        """Each of them by its number and name.

        Its object_id follows the name as it does in lists. What follows a number can be copied from
        what was said last.
        """
        if not self.number:
            return say("count nothing", {"thing": name})
        each = [_numbered(n, seen) for n, seen in enumerate(self.shown, start=1)]
        if self.gone:
            each.append(f"({self.number}) {self.gone} that went along with what I lifted")
        return say("count each", {"thing": name, "each": "; ".join(each)})


def _begin(asked: ScriptedQuestion) -> Plan[None]:
    """Clear away all else that could hide one, keep those that count, and take the most seen."""
    name = asked.subject

    def counts(seen: Seen) -> bool:
        return same(seen.name or "", name)

    search = Search.of(asked, counts)
    yield from search.begin()
    now = most = _Tally(search.graph.called(name))
    search.remark(_gone_through(search.graph, now, asked.say))
    search.remark(now.told(name, asked.say))
    search.remark_to_search()
    listed = _listed(search.graph)
    while not search.complete and (yield from search.clear_one()):
        now = now.after(search.graph.called(name), removed=search.removed_last)
        search.remark(_gone_through(search.graph, now, asked.say, listed))
        listed |= _listed(search.graph)
        search.remark(now.told(name, asked.say))
        search.remark_to_search()
        # Of equal ones the last: things that were moved have other object_ids since.
        most = now if now.number >= most.number else most
    if search.complete or asked.bold:
        each = most.each if most is not now else []
        found = _counted(asked.question, most.number, each, sure=search.complete)
        yield from conclude(asked, found, search)


def _numbered(number: int, seen: Seen) -> str:
    return f"({number}) {seen.name}, {seen.object_id or seen.place}"


def _gone_through(graph: Graph, tally: _Tally, say: Say, listed: _Listed = frozenset()) -> str:
    """All of a list in its order, and which of them count: nothing if it tells no object_ids.

    Then one thing after another is judged, and nobody has to know when to stop counting.

    Args:
        graph: What shows.
        tally: Those that count.
        say: Gives the words.
        listed: What earlier lists had; what has the same object_id and name isn't said again.
    """
    counted = {seen.number: f", so {_numbered(n, seen)}" for n, seen in enumerate(tally.shown, 1)}
    told = [
        f"{seen.object_id} {seen.name or _UNNAMED}{counted.get(seen.number, '')}"
        for seen in graph.objects
        if seen.object_id and (seen.object_id, seen.name) not in listed
    ]
    occasion = "gone through later" if listed else "gone through"
    return say(occasion, {"each": "; ".join(told)}) if told else ""


def _listed(graph: Graph) -> _Listed:
    return frozenset((seen.object_id, seen.name) for seen in graph.objects if seen.object_id)


def _counted(
    question: Question, number: int, each: Sequence[str], *, sure: bool
) -> FoundAnswer | None:
    """The letter of a number, or else that of none of them.

    Args:
        question: Has the options.
        number: How many there are.
        each: What to call them, if they weren't told.
        sure: Whether this isn't a guess.
    """
    letters = [letter for letter, text in question.options if text.strip() == str(number)]
    letter = letters[0] if letters else none_of_them(question)
    if letter is None:
        return None
    kind = "count seen" if each else "count" if number else "count zero"
    occasion = kind if letters else f"{kind} none"
    slots = {"number": str(number), "each": joined(each) if each else ""}
    return FoundAnswer(letter, occasion if sure else "guess", slots)


def _at_sight(asked: FirstLookQuestion, say: Say) -> FirstLookAnswer | None:
    """Only if nothing is half hidden and nothing could hide another one."""

    def counts(seen: Seen) -> bool:
        return same(seen.name or "", asked.subject)

    search = Search(counts, "grasp", np.random.default_rng(0), graph=asked.graph)
    if not search.complete:
        return None
    # Who answers at sight was given no object_ids.
    each = [seen.place for seen in asked.graph.called(asked.subject)]
    found = _counted(asked.question, len(each), each, sure=True)
    if found is None:
        return None
    return FirstLookAnswer(found.letter, found.told(asked.question, say))


PLAN = TypePlan(_begin, _at_sight)
