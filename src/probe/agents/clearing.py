"""Clears away what could hide something, the most promising first."""

from __future__ import annotations

from collections import Counter, defaultdict
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field

import numpy as np

from probe.agents.cover_nouns import hider
from probe.agents.moves import Outcome, Plan, Way, look, move_away
from probe.agents.phrases import Reason, Say, silent
from probe.agents.reading import Graph, Seen
from probe.agents.type_plan import ScriptedQuestion
from probe.toolshed.toolshed import MANIPULATIONS
from probe.types import USUAL_SCALE, PictureScale

LARGE_PX = 120
"""A thing whose box is at least this long and wide may hide something of everyday size."""

_TRIES, _HIDERS_TRIES = 2, 5
_WITHSTOOD = 0.45
"""What a failed try takes from a thing's promise: after two, a hollow one still comes first."""


@dataclass
class Search:
    """One search under and behind things.

    Attributes:
        keep: Which things must stay on the table.
        first: What to try first on each thing.
        rng: Breaks ties between directions.
        graph: What showed last.
        spent: Manipulations so far.
        removed_last: Whether the last manipulation took a thing off the table.
        remarks: What is said of the graph before whatever is done next.
        say: Gives the words that go with each call.
        scale: Of the pictures.
        gentle: Whether it only lifts, and nothing but what it is to clear: others may not move.
        budget: Manipulations that it may spend.
    """

    keep: Callable[[Seen], bool]
    first: Way
    rng: np.random.Generator
    graph: Graph = field(default_factory=Graph)
    spent: int = 0
    removed_last: bool = False
    remarks: str = ""
    say: Say = silent
    scale: PictureScale = USUAL_SCALE
    gentle: bool = False
    budget: int = MANIPULATIONS
    _tried: defaultdict[str, list[tuple[Way, Outcome]]] = field(
        default_factory=lambda: defaultdict[str, list[tuple[Way, Outcome]]](list)
    )
    _searched: set[str] = field(default_factory=set[str])
    _before: Graph = field(default_factory=Graph)

    @classmethod
    def of(
        cls, asked: ScriptedQuestion, keep: Callable[[Seen], bool] = lambda seen: False
    ) -> Search:
        """Before the first look for what a question asks; by default all things may be moved."""
        return cls(keep, asked.first, asked.rng, say=asked.say, scale=asked.question.scale)

    def begin(self, words: str = "") -> Plan[None]:
        """Look for the first time, after what is said of the question."""
        yield from self._look(f"{words} {self.say('look', {})}".strip())

    def clear_one(self) -> Plan[bool]:
        """Move the most promising thing away and look again; False if there is none left."""
        candidates = self._candidates()
        if not candidates:
            return False
        chosen = max(candidates, key=self._promise)
        yield from self.clear(chosen, Reason(self._attraction(chosen)))
        return True

    def may_clear(self, seen: Seen) -> bool:
        """Whether a thing hasn't withstood too often, and manipulations are left."""
        most = _HIDERS_TRIES if hider(seen.name or "") else _TRIES
        return len(self._tried[seen.name or ""]) < most and self.spent < self.budget

    def clear(self, seen: Seen, why: Reason) -> Plan[None]:
        """Move a thing away, or what lies on it and keeps it there, and look again.

        Args:
            seen: The thing.
            why: What for.
        """
        obstacle = self._obstacle(seen)
        if obstacle is not None:
            seen, why = obstacle, Reason("obstacle", seen.name or "")
        name, way = seen.name or "", self._way(seen.name or "")
        self.spent += 1
        words = self._reasons(seen, way, why)
        outcome = yield from move_away(seen, self.graph, way, self.rng, self.say, words, self.scale)
        self._tried[name].append((way, outcome))
        before = _names(self.graph)
        tried_on = {"thing": name, "id": seen.object_id or ""}
        yield from self._look(self.say(f"look {outcome}", tried_on))
        now = _names(self.graph)
        shown = any(now[other] > before[other] for other in now if other != name)
        self.removed_last = left = outcome == "gone" and name not in now
        if left or (outcome in ("gone", "pushed") and (shown or hider(name) is None)):
            self._searched.add(name)

    def remark(self, words: str) -> None:
        """Say something of what shows, before what is done next."""
        self.remarks = self.after_remarks(words)

    def after_remarks(self, words: str) -> str:
        """Words of what is done next, after what is said of the graph."""
        return f"{self.remarks} {words}".strip()

    def remark_moved(self) -> None:
        """Say which known things have another object_id than in the list before.

        Whoever names them next finds that one behind the name, and not the old one.
        """
        ids = {seen.object_id for seen in self._before.objects}
        names = {seen.name for seen in self._before.named}
        now = [it for it in self.graph.named if it.object_id not in ids and it.name in names]
        if each := with_ids(now):
            self.remark(self.say("moved", {"each": each}))

    def remark_to_search(self) -> None:
        """Say which listed things may well hide something, the most promising first.

        All of them: then the next such list can be copied from what stands behind the first of this
        one, also if that is "nothing more". Nothing is said where lists have no object_ids.
        """
        promising = [seen for seen in self._candidates() if self._promise(seen)[0] > 0]
        promising.sort(key=self._promise, reverse=True)
        if any(seen.object_id for seen in self.graph.objects):
            each = "; ".join(filter(None, (with_ids(promising), "nothing more")))
            self.remark(self.say("to search", {"each": each}))

    @property
    def complete(self) -> bool:
        """Whether nothing is half hidden and nothing is left that may well hide something."""
        return not self.graph.unclear and not any(_hides(s) for s in self._unsearched())

    def _look(self, words: str) -> Plan[None]:
        self._before = self.graph
        self.graph, self.remarks = (yield from look(words)), ""

    def _candidates(self) -> list[Seen]:
        """Things to search that may be cleared."""
        return [seen for seen in self._unsearched() if self.may_clear(seen)]

    def _unsearched(self) -> list[Seen]:
        """Things that still stand where something may lie under them.

        Named things only: what is half hidden may be what is looked for. A hollow thing that was
        pushed took along what is beneath, and a flat one may have, unless something came to light.
        """
        done = self._searched
        return [s for s in self.graph.named if not self.keep(s) and (s.name or "") not in done]

    def _way(self, name: str) -> Way:
        """What to try on a thing: lift it if possible, push it where that can't be done."""
        if self.gentle:
            return "grasp"
        tried = self._tried[name]
        if not tried:
            return self.first
        way, outcome = tried[-1]
        if way == "push":
            return "grasp"
        lost = outcome == "lost" and len(tried) == 1
        return "grasp" if lost else "push"

    def _obstacle(self, seen: Seen) -> Seen | None:
        """What lies on a thing that couldn't be lifted, the highest that may be moved; or None."""
        tried = self._tried[seen.name or ""]
        if self.gentle or not tried or tried[-1][1] not in ("no grip", "blocked", "unfound"):
            return None
        over = self.graph.over(seen)
        movable = [s for s in self.graph.named if s.number in over and not self.keep(s)]
        movable = [s for s in movable if self.may_clear(s)]
        return min(movable, key=lambda each: len(self.graph.over(each)), default=None)

    def _reasons(self, seen: Seen, way: Way, why: Reason) -> str:
        """What shows, why a thing is moved, and why in this way."""
        name = seen.name or ""
        tried = self._tried[name]
        how = f"{way} {tried[-1][1]}" if tried else way
        if way == "grasp" and tried[-1:] == [("grasp", "blocked")]:
            how = "grasp again"
        slots = {"thing": name, "id": seen.object_id or "", **why.slots}
        return self.after_remarks(f"{self.say(why.reason, slots)} {self.say(how, slots)}".strip())

    def _attraction(self, seen: Seen) -> str:
        """Why this thing, of all that might hide something: the occasion to say so."""
        kind = hider(seen.name or "")
        if kind == "hollow":
            return "hollow"
        if any(seen.number in self.graph.over(other) for other in self.graph.unclear):
            return "unclear"
        return "flat" if kind == "flat" and _is_large(seen) else "largest"

    def _promise(self, seen: Seen) -> tuple[float, int]:
        """What may hide more first: hollow things, and what covers something half hidden."""
        unclear = any(seen.number in self.graph.over(other) for other in self.graph.unclear)
        rank = _hides(seen) + 1.5 * unclear
        return rank - _WITHSTOOD * len(self._tried[seen.name or ""]), seen.area


def with_ids(things: Iterable[Seen]) -> str:
    """Things by name and object_id; empty where lists have no object_ids."""
    return "; ".join(f"{seen.name}, {seen.object_id}" for seen in things if seen.object_id)


def _names(graph: Graph) -> Counter[str]:
    return Counter(seen.name for seen in graph.named if seen.name is not None)


def _hides(seen: Seen) -> int:
    """How well a thing may hide another one: 0 if not at all."""
    kind = hider(seen.name or "")
    return 2 if kind == "hollow" else int(kind == "flat" and _is_large(seen))


def _is_large(seen: Seen) -> bool:
    left, top, right, bottom = seen.box
    return min(right - left, bottom - top) + 1 >= LARGE_PX
