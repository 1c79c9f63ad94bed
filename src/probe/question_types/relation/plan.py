"""How the scripted agent goes about Relation: it finds where to start, then looks at the next."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass, field

from probe.agents.like_covers import LikeCovers
from probe.agents.moves import Plan
from probe.agents.phrases import Reason
from probe.agents.reading import Seen
from probe.agents.type_plan import ScriptedQuestion, TypePlan
from probe.agents.uncovering import FoundAnswer, answer_naming, conclude
from probe.question_types.relation.truth import RING, clockwise, next_along

Point = tuple[float, float]


@dataclass
class _Ring:
    """What is known of covers that stand in a ring.

    Attributes:
        asked: The question.
        homes: Where each cover stood at first, by a number: pixels (u, v).
        order: These numbers, clockwise.
        found: What came to light, by the number of its cover.
    """

    asked: ScriptedQuestion
    homes: dict[int, Point]
    order: tuple[int, ...]
    found: dict[int, str] = field(default_factory=dict[int, str])

    @staticmethod
    def of(asked: ScriptedQuestion, covers: Sequence[Seen]) -> _Ring | None:
        """The ring of some covers; None if they form none."""
        homes = {number: _middle(seen) for number, seen in enumerate(covers)}
        try:
            return _Ring(asked, homes, clockwise(homes)) if len(homes) == RING else None
        except ValueError:
            return None

    def home_of(self, cover: Seen) -> int:
        """Where a cover stood at first: the nearest place under which nothing has been found."""
        at, open_ = _middle(cover), [n for n in self.homes if n not in self.found]
        return min(open_ or self.homes, key=lambda number: math.dist(self.homes[number], at))

    @property
    def start(self) -> int | None:
        """The place of what the question names, seen or all that is left; None if not known."""
        named = [number for number, name in self.found.items() if _says(self.asked, name)]
        if not named and len(self.found) == RING - 1:
            named = [number for number in self.homes if number not in self.found]
        return named[0] if len(named) == 1 else None

    @property
    def wanted(self) -> int | None:
        """The place that is asked for; None if it isn't known yet."""
        start = self.start
        return None if start is None else next_along(self.asked.form, self.order, start)

    def answer(self) -> FoundAnswer | None:
        """The letter of what is in the place that is asked for; None if that isn't known."""
        if self.start is None or self.wanted not in self.found:
            return None
        name = self.found[self.wanted]
        other = self.found.get(self.start, "thing that is named")
        return answer_naming(self.asked.question, name, "ring", {"thing": name, "other": other})


def _begin(asked: ScriptedQuestion) -> Plan[None]:
    """Lift covers until it is clear where to start, then the next one from there."""
    covers = LikeCovers.of(asked)
    yield from covers.begin()
    ring = _Ring.of(asked, covers.left)
    found: FoundAnswer | None = None
    while ring is not None and found is None and (chosen := covers.first) is not None:
        wanted = ring.wanted
        chosen = next((it for it in covers.left if ring.home_of(it) == wanted), chosen)
        home = ring.home_of(chosen)
        if not (yield from covers.clear_next(_why(home, wanted), chosen)):
            break
        for seen in covers.newcomers:
            if seen.name and seen.name not in ring.found.values():
                ring.found.setdefault(home, seen.name)
        found = ring.answer()
    yield from conclude(asked, found, covers.search)


def _why(home: int, wanted: int | None) -> Reason:
    """Why the cover at a place is lifted, if another one may be asked for."""
    if wanted is None:
        return Reason("any of the ring")
    return Reason("next of the ring" if home == wanted else "other of the ring")


def _says(asked: ScriptedQuestion, name: str) -> bool:
    """Whether a question has a name in it, as whole words."""
    return re.search(rf"\b{re.escape(name)}\b", asked.question.text) is not None


def _middle(seen: Seen) -> Point:
    left, top, right, bottom = seen.box
    return (left + right) / 2, (top + bottom) / 2


PLAN = TypePlan(_begin)
