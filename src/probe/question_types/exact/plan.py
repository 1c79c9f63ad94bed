"""How the scripted agent goes about Exact: it lifts what is named, pushes nothing, and looks."""

from __future__ import annotations

from probe.agents.moves import Plan
from probe.agents.named_removal import gentle_search, left_of, next_named
from probe.agents.phrases import Reason
from probe.agents.type_plan import ScriptedQuestion, TypePlan
from probe.agents.uncovering import FoundAnswer, conclude, uncovered


def _begin(asked: ScriptedQuestion) -> Plan[None]:
    """Lift all that is named, one after the other, and name what has come to light."""
    search, names = gentle_search(asked), asked.subject.split(", ")
    yield from search.begin()
    known = {seen.name for seen in search.graph.named}
    places = [seen.box for seen in left_of(search, names)]
    while (chosen := next_named(search, names)) is not None:
        yield from search.clear(chosen, Reason("only named"))
    found: FoundAnswer | None = None
    if places and not left_of(search, names):
        found = uncovered(asked.question, search.graph, known, places)
    yield from conclude(asked, found, search)


PLAN = TypePlan(_begin)
