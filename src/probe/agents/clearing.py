"""Clears away what could hide something, the most promising first."""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from probe.agents.moves import Plan, Way, look, move_away
from probe.agents.reading import Graph, Seen

LARGE_PX = 120
"""A thing whose box is at least this long and wide may hide something of everyday size."""

_TRIES = 3
_BUDGET = 10


@dataclass
class Search:
    """One search under and behind things.

    Attributes:
        keep: Which things must stay on the table.
        first: What to try first on each thing; the other way follows if that fails.
        rng: Breaks ties between directions.
        bold: Whether to take a spent budget for a complete search.
        graph: What showed last.
        spent: Manipulations so far.
    """

    keep: Callable[[Seen], bool]
    first: Way
    rng: np.random.Generator
    bold: bool = False
    graph: Graph = field(default_factory=Graph)
    spent: int = 0
    _tries: Counter[str] = field(default_factory=Counter[str])
    _checked: set[str] = field(default_factory=set[str])
    _removed: set[str] = field(default_factory=set[str])
    _known: set[str] = field(default_factory=set[str])

    def begin(self) -> Plan[None]:
        """Look for the first time."""
        yield from self._look()

    def clear_one(self) -> Plan[bool]:
        """Move the most promising thing away and look again; False if there is none left."""
        candidates = self._candidates()
        if not candidates or self.spent >= _BUDGET:
            return False
        yield from self.clear(max(candidates, key=self._promise))
        return True

    def may_clear(self, seen: Seen) -> bool:
        """Whether a thing hasn't withstood too often, and manipulations are left."""
        return self._tries[seen.name or ""] < _TRIES and self.spent < _BUDGET

    def clear(self, seen: Seen) -> Plan[bool]:
        """Move a thing away and look again; says whether the move worked."""
        name = seen.name or ""
        other: Way = "push" if self.first == "grasp" else "grasp"
        way = self.first if self._tries[name] % 2 == 0 else other
        self._tries[name] += 1
        self.spent += 1
        worked = yield from move_away(seen, self.graph, way, self.rng)
        if worked:
            self._checked.add(name)
        if worked and way == "grasp":
            self._removed.add(name)
        yield from self._look()
        return worked

    @property
    def complete(self) -> bool:
        """Whether nothing is half hidden and each thing that could hide much was moved once.

        A bold search ends with the budget too, if each half hidden thing may be a known one:
        a guess, since a table holds more large things than there are manipulations.
        """
        if self.bold and self.spent >= _BUDGET:
            return self._all_known
        large = [seen for seen in self._unsearched() if _is_large(seen)]
        return not self.graph.unclear and not large

    @property
    def _all_known(self) -> bool:
        """Whether each half hidden thing may be one that was seen before and shows no more."""
        showing = {seen.name for seen in self.graph.named}
        return len(self.graph.unclear) <= len(self._known - self._removed - showing)

    def _look(self) -> Plan[None]:
        self.graph = yield from look()
        self._known |= {seen.name for seen in self.graph.named if seen.name is not None}

    def _unsearched(self) -> list[Seen]:
        """Things that still stand where something may lie under them.

        Named things only: what is half hidden may be what is looked for.
        """
        moved = self._checked
        return [s for s in self.graph.named if not self.keep(s) and (s.name or "") not in moved]

    def _candidates(self) -> list[Seen]:
        return [s for s in self._unsearched() if self._tries[s.name or ""] < _TRIES]

    def _promise(self, seen: Seen) -> tuple[bool, int]:
        """Next to something half hidden first, then by size; a failure makes it less so."""
        unclear = {other.number for other in self.graph.unclear}
        fresh = seen.area // (1 + self._tries[seen.name or ""])
        return not unclear.isdisjoint(self.graph.meeting(seen)), fresh


def _is_large(seen: Seen) -> bool:
    left, top, right, bottom = seen.box
    return min(right - left, bottom - top) + 1 >= LARGE_PX
