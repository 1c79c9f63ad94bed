"""Lifts like covers one after the other, and keeps track of what comes to light beneath them."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from probe.agents.clearing import Search
from probe.agents.moves import Plan
from probe.agents.phrases import Reason
from probe.agents.reading import Box, Graph, Seen
from probe.agents.type_plan import ScriptedQuestion
from probe.agents.uncovering import newcomers


@dataclass
class LikeCovers:
    """Covers that go by one name, the subject of a question.

    Attributes:
        asked: The question.
        search: What showed last, and what has been tried on the cover that is next.
        known: Names of all that showed at first.
        places: Boxes of all places where a cover has been seen.
        count: Covers that showed at first.
    """

    asked: ScriptedQuestion
    search: Search
    known: set[str | None] = field(default_factory=set[str | None])
    places: list[Box] = field(default_factory=list[Box])
    count: int = 0

    @staticmethod
    def of(asked: ScriptedQuestion) -> LikeCovers:
        """Before the first look."""
        return LikeCovers(asked, _search(asked, Graph(), 0))

    def begin(self) -> Plan[None]:
        """Look for the first time."""
        yield from self.search.begin()
        self.known = {seen.name for seen in self.search.graph.named}
        self.places = [seen.box for seen in self.left]
        self.count = len(self.places)

    @property
    def left(self) -> tuple[Seen, ...]:
        """Those that are still on the table."""
        return self.search.graph.called(self.asked.subject)

    @property
    def newcomers(self) -> list[Seen]:
        """What has come to light where covers are or were, and can be named."""
        return newcomers(self.search.graph, self.known, self.places)

    @property
    def first(self) -> Seen | None:
        """The one that comes first; None if none is left."""
        return min(self.left, key=_place, default=None)

    def clear_next(self, why: Reason, chosen: Seen | None = None) -> Plan[bool]:
        """Clear one away and look again; False if none is left, or no manipulation.

        Args:
            why: What for.
            chosen: One of those that are left; None for the one that comes first.
        """
        left, chosen = self.left, chosen or self.first
        if chosen is None or self.search.spent >= self.search.budget:
            return False
        if not self.search.may_clear(chosen):
            # What withstood goes by the same name, but nothing else is worth a try.
            self.search = _search(self.asked, self.search.graph, self.search.spent)
        yield from self.search.clear(chosen, why)
        if len(self.left) < len(left):
            # The next one looks the same, but nothing has been tried on it.
            self.search = _search(self.asked, self.search.graph, self.search.spent)
        # Pushed, a cover takes along what is beneath: that is where it went.
        self.places += [seen.box for seen in self.left]
        return True


def _search(asked: ScriptedQuestion, graph: Graph, spent: int) -> Search:
    return replace(Search.of(asked), graph=graph, spent=spent)


def _place(seen: Seen) -> tuple[int, int]:
    return seen.point
