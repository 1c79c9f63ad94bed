"""How the scripted agent goes about Exact: it lifts what is named, pushes nothing, and looks."""

from __future__ import annotations

from probe.agents.clearing import Search
from probe.agents.moves import Plan
from probe.agents.phrases import Reason
from probe.agents.reading import Seen
from probe.agents.type_plan import ScriptedQuestion, TypePlan
from probe.agents.uncovering import FoundAnswer, conclude, uncovered


def _begin(asked: ScriptedQuestion) -> Plan[None]:
    """Lift all that is named, one after the other, and name what has come to light."""
    scale, names = asked.question.scale, asked.subject.split(", ")
    search = Search(lambda seen: False, "grasp", asked.rng, say=asked.say, scale=scale, gentle=True)
    yield from search.begin()
    known = {seen.name for seen in search.graph.named}
    places = [seen.box for seen in _left(search, names)]
    while fresh := [seen for seen in _left(search, names) if search.may_clear(seen)]:
        # What lies on top of the others goes first: it would drag them along.
        highest = min(fresh, key=lambda seen: len(search.graph.over(seen)))
        yield from search.clear(highest, Reason("only named"))
    found: FoundAnswer | None = None
    if places and not _left(search, names):
        found = uncovered(asked.question, search.graph, known, places)
    yield from conclude(asked, found, search)


def _left(search: Search, names: list[str]) -> list[Seen]:
    return [seen for name in names for seen in search.graph.called(name)]


PLAN = TypePlan(_begin)
