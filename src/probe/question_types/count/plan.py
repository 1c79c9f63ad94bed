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


@dataclass(frozen=True)
class _Tally:
    """Those that show at one time, and how many had left the table by then.

    Attributes:
        kept: Those that showed before.
        gone: How many aren't on the table any more.
        fresh: Those that have come to light.
        lost_sight: Whether some were counted before and none of these has its object_id any more.
    """

    kept: Sequence[Seen] = ()
    gone: int = 0
    fresh: Sequence[Seen] = ()
    lost_sight: bool = False

    def after(self, shown: Sequence[Seen], *, removed: bool) -> _Tally:
        """The next one.

        Args:
            shown: Those that show now.
            removed: Whether something was taken off the table since; what lay on it went along.
        """
        lost = max(0, len(self.shown) - len(shown)) if removed else 0
        order = {seen.object_id: number for number, seen in enumerate(self.shown)}
        kept = [seen for seen in shown if seen.object_id in order]
        kept.sort(key=lambda seen: order[seen.object_id])
        fresh = [seen for seen in shown if seen.object_id not in order]
        lost_sight = bool(self.number or self.lost_sight) and not kept
        return _Tally(kept, self.gone + lost, fresh, lost_sight)

    @property
    def shown(self) -> list[Seen]:
        """All that show."""
        return [*self.kept, *self.fresh]

    @property
    def number(self) -> int:
        """How many these are."""
        return len(self.shown) + self.gone

    @property
    def each(self) -> list[str]:
        """What to call each of them."""
        shown = [seen.object_id or seen.place for seen in self.shown]
        return [*shown, f"{self.gone} that went along with what I lifted"] if self.gone else shown

    @property
    def numbers(self) -> dict[int, str]:
        """What to call each that shows, by its place in the list: number, name and object_id.

        What has come to light is numbered after all others.
        """
        first = enumerate(self.kept, start=1)
        then = enumerate(self.fresh, start=len(self.kept) + self.gone + 1)
        return {seen.number: _numbered(n, seen) for n, seen in (*first, *then)}

    def told(self, name: str, say: Say) -> str:
        """Each that was counted before by its number and name.

        Its object_id follows the name as it does in lists. What follows a number can be copied from
        what was said last, and whoever goes through what is new counts on from the last number.
        """
        numbers = self.numbers
        each = [numbers[seen.number] for seen in self.kept]
        if self.gone:
            number = len(self.kept) + self.gone
            each.append(f"({number}) {self.gone} that went along with what I lifted")
        if not each:
            return say("count renamed" if self.lost_sight else "count nothing", {"thing": name})
        return say("count each", {"thing": name, "each": "; ".join(each)})


def _begin(asked: ScriptedQuestion) -> Plan[None]:
    """Clear away all else that could hide one, keep those that count, and take the most seen."""
    name = asked.subject

    def counts(seen: Seen) -> bool:
        return same(seen.name or "", name)

    search = Search.of(asked, counts)
    yield from search.begin()
    now = most = _Tally(fresh=search.graph.called(name))
    search.remark(_gone_through(search.graph, now, asked.say))
    search.remark_to_search()
    while not search.complete:
        before = search.graph
        if not (yield from search.clear_one()):
            break
        now = now.after(search.graph.called(name), removed=search.removed_last)
        search.remark(now.told(name, asked.say))
        search.remark(_gone_through(search.graph, now, asked.say, before))
        search.remark_to_search()
        # Of equal ones the last: things that were moved have other object_ids since.
        most = now if now.number >= most.number else most
    if search.complete or asked.bold:
        each = most.each if most is not now else []
        found = _counted(asked.question, most.number, each, sure=search.complete)
        yield from conclude(asked, found, search)


def _numbered(number: int, seen: Seen) -> str:
    return f"({number}) {seen.name}, {seen.object_id or seen.place}"


def _gone_through(graph: Graph, tally: _Tally, say: Say, before: Graph | None = None) -> str:
    """All of a list in its order, and which of them count: nothing if it tells no object_ids.

    Then one thing after another is judged, and nobody has to know when to stop counting.

    Args:
        graph: What shows.
        tally: Those that count.
        say: Gives the words.
        before: What showed before, if anything did: then only things are gone through that this
            list is the first to tell with their object_id and name.
    """
    numbers = tally.numbers
    things = [seen for seen in graph.objects if seen.object_id]
    if before is not None:
        known = {(seen.object_id, seen.name) for seen in before.objects}
        things = [it for it in things if it.name and (it.object_id, it.name) not in known]
    each = [
        f"{seen.object_id} {seen.name or _UNNAMED}"
        + (f", so {numbers[seen.number]}" if seen.number in numbers else "")
        for seen in things
    ]
    occasion = "gone through" if before is None else "gone through later"
    return say(occasion, {"each": "; ".join(each)}) if each else ""


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
