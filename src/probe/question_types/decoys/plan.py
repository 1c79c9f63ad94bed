"""How the scripted agent goes about Decoys: it lifts one like cover after the other, and looks."""

from __future__ import annotations

from probe.agents.like_covers import LikeCovers
from probe.agents.moves import Plan
from probe.agents.phrases import Reason
from probe.agents.type_plan import ScriptedQuestion, TypePlan
from probe.agents.uncovering import FoundAnswer, conclude, is_offered, uncovered


def _begin(asked: ScriptedQuestion) -> Plan[None]:
    """Lift covers until an option has come to light, or something else from under each."""
    covers = LikeCovers.of(asked)
    yield from covers.begin()
    found: FoundAnswer | None = None
    while covers.places:
        offered = any(is_offered(asked.question, seen) for seen in covers.newcomers)
        if offered or not covers.left:
            graph = covers.search.graph
            found = uncovered(asked.question, graph, covers.known, covers.places)
            break
        if not (yield from covers.clear_next(Reason("like covers"))):
            break
    yield from conclude(asked, found, covers.search)


PLAN = TypePlan(_begin)
