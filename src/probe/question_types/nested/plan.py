"""How the scripted agent goes about Nested: it lifts what is named, then what that has hidden."""

from __future__ import annotations

from probe.agents.clearing import Search
from probe.agents.moves import Plan
from probe.agents.phrases import Reason
from probe.agents.reading import Box, Seen
from probe.agents.type_plan import ScriptedQuestion, TypePlan
from probe.agents.uncovering import (
    FoundAnswer,
    around,
    clear_around,
    conclude,
    is_offered,
    newcomers,
    uncovered,
)


def _begin(asked: ScriptedQuestion) -> Plan[None]:
    """Clear the outer cover away, then the inner one, and name what comes to light."""
    search = Search.of(asked)
    yield from search.begin()
    known = {seen.name for seen in search.graph.named}
    place = around(seen.box for seen in search.graph.called(asked.subject))
    found: FoundAnswer | None = None
    if place is not None:
        inner = yield from _come_to_light(asked, search, known, place)
        if inner is not None:
            place = around([place, inner.box]) or place
            if not is_offered(asked.question, inner):
                known.add(inner.name)
            found = yield from _lift_inner(asked, search, known, inner, place)
    yield from conclude(asked, found, search)


def _come_to_light(
    asked: ScriptedQuestion, search: Search, known: set[str | None], place: Box
) -> Plan[Seen | None]:
    """Clear the outer cover away; the largest thing that then shows in its place, or None."""
    while True:
        left = search.graph.called(asked.subject)
        place = around([place, *(seen.box for seen in left)]) or place
        new = newcomers(search.graph, known, [place])
        if new:
            return next((it for it in new if is_offered(asked.question, it)), max(new, key=_area))
        fresh = [seen for seen in left if search.may_clear(seen)]
        if fresh:
            yield from search.clear(fresh[0], Reason("outer cover"))
        elif not (yield from clear_around(search, place, known)):
            return None


def _lift_inner(
    asked: ScriptedQuestion, search: Search, known: set[str | None], inner: Seen, place: Box
) -> Plan[FoundAnswer | None]:
    """Clear the inner cover away; what comes to light then."""
    why = Reason("inner cover", asked.subject)
    while True:
        left = search.graph.called(inner.name or "")
        place = around([place, *(seen.box for seen in left)]) or place
        found = uncovered(asked.question, search.graph, known, [place])
        if found is not None:
            return found
        fresh = [seen for seen in left if search.may_clear(seen)]
        if fresh:
            yield from search.clear(fresh[0], why)
        elif not (yield from clear_around(search, place, known)):
            return None


def _area(seen: Seen) -> int:
    return seen.area


PLAN = TypePlan(_begin)
