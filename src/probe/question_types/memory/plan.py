"""How the scripted agent goes about Memory: it lifts all that is named and notes what was where."""

from __future__ import annotations

import math
from dataclasses import dataclass, field

from probe.agents.moves import Plan
from probe.agents.named_removal import gentle_search, left_of, next_named
from probe.agents.phrases import Reason
from probe.agents.reading import Box, Graph
from probe.agents.type_plan import ScriptedQuestion, TypePlan
from probe.agents.uncovering import FoundAnswer, answer_naming, conclude, newcomers


@dataclass
class _Notes:
    """What has come to light where covers stood.

    Attributes:
        asked: The question.
        known: Names of all that showed at first.
        homes: Where each cover stood at first, by its name.
        found: Names of what came to light, by that of its cover.
    """

    asked: ScriptedQuestion
    known: set[str | None]
    homes: dict[str, Box]
    found: dict[str, str] = field(default_factory=dict[str, str])

    @staticmethod
    def of(asked: ScriptedQuestion, graph: Graph) -> _Notes:
        """Before anything is lifted."""
        names = asked.subject.split(", ")
        homes = {name: seen.box for name in names for seen in graph.called(name)}
        return _Notes(asked, {seen.name for seen in graph.named}, homes)

    def take(self, graph: Graph) -> None:
        """Note what is new in the place of a cover that is gone, and in no other one's."""
        for seen in newcomers(graph, self.known, list(self.homes.values())):
            home = min(self.homes, key=lambda name: _apart(self.homes[name], seen.box))
            if seen.name and not graph.called(home) and seen.name not in self.found.values():
                self.found.setdefault(home, seen.name)

    def answer(self) -> FoundAnswer | None:
        """The letter of what was under the cover that is asked about; None if that isn't known."""
        cover = self.asked.subject.split(", ")[0]
        name = self.found.get(cover)
        if name is None:
            return None
        slots = {"thing": name, "other": cover}
        return answer_naming(self.asked.question, name, "remembered", slots)


def _begin(asked: ScriptedQuestion) -> Plan[None]:
    """Lift all that is named, one after the other, and note what each of it hid."""
    search, names = gentle_search(asked), asked.subject.split(", ")
    yield from search.begin()
    notes = _Notes.of(asked, search.graph)
    while (chosen := next_named(search, names)) is not None:
        yield from search.clear(chosen, Reason("each named"))
        notes.take(search.graph)
    found = None if left_of(search, names) else notes.answer()
    yield from conclude(asked, found, search)


def _apart(one: Box, other: Box) -> float:
    """Pixels from the middle of a box to that of another."""
    return math.dist(*(((b[0] + b[2]) / 2, (b[1] + b[3]) / 2) for b in (one, other)))


PLAN = TypePlan(_begin)
