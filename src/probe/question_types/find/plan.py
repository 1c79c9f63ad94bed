"""How the scripted agent goes about Find: it searches until an option shows, and points at it."""

from __future__ import annotations

from probe.agents.clearing import Search
from probe.agents.moves import Plan, answer, none_of_them
from probe.agents.phrases import Say
from probe.agents.reading import Graph, Seen
from probe.agents.type_plan import FirstLookAnswer, FirstLookQuestion, ScriptedQuestion, TypePlan
from probe.agents.uncovering import FoundAnswer, is_offered, options_told, remark_new
from probe.episodes.turns import Question


def _begin(asked: ScriptedQuestion) -> Plan[None]:
    """Clear things away until one of the options shows, and point at it."""
    question, say = asked.question, asked.say

    def offered(seen: Seen) -> bool:
        return is_offered(question, seen)

    search = Search.of(asked, offered)
    yield from search.begin(options_told(question, say))
    known = {seen.name for seen in search.graph.named}
    while not (shown := _shown_options(question, search.graph)):
        search.remark(say("find not yet", {}))
        search.remark_to_search()
        if search.complete or not (yield from search.clear_one()):
            break
        search.remark_moved()
        remark_new(search, known, question)
    if shown:
        letter, seen = shown[0]
        words = search.after_remarks(_found(letter, seen).told(question, say))
        pointing = say("find point", {"id": seen.object_id}) if seen.object_id else ""
        yield from answer(letter, seen.point, f"{words} {pointing}".strip())
    elif (search.complete or asked.bold) and (none := none_of_them(question)):
        lacking = FoundAnswer(none, "find none" if search.complete else "guess", {})
        yield from answer(none, words=search.after_remarks(lacking.told(question, say)))


def _shown_options(question: Question, graph: Graph) -> list[tuple[str, Seen]]:
    return [(letter, seen) for letter, text in question.options for seen in graph.called(text)]


def _at_sight(asked: FirstLookQuestion, say: Say) -> FirstLookAnswer | None:
    for letter, seen in _shown_options(asked.question, asked.graph):
        words = _found(letter, seen).told(asked.question, say)
        return FirstLookAnswer(letter, words, seen.point)
    return None


def _found(letter: str, seen: Seen) -> FoundAnswer:
    return FoundAnswer(letter, "find", {"thing": seen.name or ""})


PLAN = TypePlan(_begin, _at_sight)
