"""How the scripted agent goes about Decoys: it lifts one like cover after the other, and looks."""

from __future__ import annotations

from probe.agents.clearing import Search
from probe.agents.moves import Plan
from probe.agents.phrases import Reason
from probe.agents.reading import Graph, Seen
from probe.agents.type_plan import ScriptedQuestion, TypePlan
from probe.agents.uncovering import FoundAnswer, conclude, is_offered, newcomers, uncovered


def _begin(asked: ScriptedQuestion) -> Plan[None]:
    """Lift covers until an option has come to light, or something else from under each."""
    search = _search(asked, Graph(), 0)
    yield from search.begin()
    known = {seen.name for seen in search.graph.named}
    places = [seen.box for seen in search.graph.called(asked.subject)]
    found: FoundAnswer | None = None
    while places:
        left = search.graph.called(asked.subject)
        # Pushed, a cover takes along what is beneath: that is where it went.
        places += [seen.box for seen in left]
        new = newcomers(search.graph, known, places)
        if not left or any(is_offered(asked.question, seen) for seen in new):
            found = uncovered(asked.question, search.graph, known, places)
            break
        fresh = [seen for seen in left if search.may_clear(seen)]
        if not fresh:
            break
        yield from search.clear(min(fresh, key=_place), Reason("like covers"))
        if len(search.graph.called(asked.subject)) < len(left):
            # The next one looks the same, but nothing has been tried on it.
            search = _search(asked, search.graph, search.spent)
    yield from conclude(asked, found, search)


def _search(asked: ScriptedQuestion, graph: Graph, spent: int) -> Search:
    scale = asked.question.scale
    return Search(
        lambda seen: False, asked.first, asked.rng, graph, spent, say=asked.say, scale=scale
    )


def _place(seen: Seen) -> tuple[int, int]:
    return seen.point


PLAN = TypePlan(_begin)
