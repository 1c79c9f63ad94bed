"""How the scripted agent goes about Count: it searches everywhere and takes the most it saw."""

from __future__ import annotations

import numpy as np

from probe.agents.clearing import Search
from probe.agents.moves import Plan, none_of_them
from probe.agents.phrases import Say
from probe.agents.reading import Seen, same
from probe.agents.type_plan import FirstLookAnswer, FirstLookQuestion, ScriptedQuestion, TypePlan
from probe.agents.uncovering import FoundAnswer, conclude
from probe.episodes.turns import Question


def _begin(asked: ScriptedQuestion) -> Plan[None]:
    """Clear away all else that could hide one, keep those that count, and take the most seen."""
    name = asked.subject

    def counts(seen: Seen) -> bool:
        return same(seen.name or "", name)

    search = Search(counts, asked.first, asked.rng, say=asked.say, scale=asked.question.scale)
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
    if search.complete or asked.bold:
        found = _counted(asked.question, most, sure=search.complete)
        yield from conclude(asked, found, search)


def _counted(question: Question, most: int, *, sure: bool) -> FoundAnswer | None:
    """The letter of a number, or else that of none of them."""
    letters = [letter for letter, text in question.options if text.strip() == str(most)]
    letter = letters[0] if letters else none_of_them(question)
    if letter is None:
        return None
    occasion = "guess" if not sure else "count" if letters else "count none"
    return FoundAnswer(letter, occasion, {"number": str(most)})


def _at_sight(asked: FirstLookQuestion, say: Say) -> FirstLookAnswer | None:
    """Only if nothing is half hidden and nothing could hide another one."""

    def counts(seen: Seen) -> bool:
        return same(seen.name or "", asked.subject)

    search = Search(counts, "grasp", np.random.default_rng(0), graph=asked.graph)
    if not search.complete:
        return None
    found = _counted(asked.question, len(asked.graph.called(asked.subject)), sure=True)
    if found is None:
        return None
    words = say(found.occasion, {**found.slots, "letter": found.letter})
    return FirstLookAnswer(found.letter, words)


PLAN = TypePlan(_begin, _at_sight)
