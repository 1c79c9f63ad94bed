"""How the scripted agent goes about Budgeted: it lifts only what is large enough."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from probe.agents.clearing import Search
from probe.agents.moves import Plan, none_of_them
from probe.agents.phrases import Reason
from probe.agents.reading import Seen, same
from probe.agents.type_plan import ScriptedQuestion, TypePlan
from probe.agents.uncovering import FoundAnswer, conclude, newcomers
from probe.types import PictureScale

_LENGTH = re.compile(r"(\d+(?:\.\d+)?) centimetres")
_LONG_ENOUGH = 1.0
"""By the length asked for, a cover that may hide it is at least so long in the picture."""

_SHORT = 0.89
"""By the same, what isn't it is at most so long."""


def _begin(asked: ScriptedQuestion) -> Plan[None]:
    """Lift covers that are large enough until something of the length shows."""
    scale, length = asked.question.scale, _length_told(asked.question.text)
    budget = asked.question.manipulations
    search = Search.of(asked)
    if budget is not None:
        search.budget = budget
    yield from search.begin()
    known = {seen.name for seen in search.graph.named}
    names = asked.subject.split(", ")
    covers = [seen for seen in _called(search, names) if _cm(seen, scale) >= _LONG_ENOUGH * length]
    wanted = [seen.name or "" for seen in covers]
    places = [seen.box for seen in covers]
    found: FoundAnswer | None = None
    while places:
        # Pushed, a cover takes along what is beneath: that is where it went.
        places += [seen.box for seen in _called(search, wanted)]
        new = newcomers(search.graph, known, places)
        found = next(_answers(asked, new, length), None)
        fresh = [seen for seen in _called(search, wanted) if search.may_clear(seen)]
        if found is not None or not fresh:
            break
        yield from search.clear(fresh[0], Reason("large enough"))
    yield from conclude(asked, found, search)


def _answers(asked: ScriptedQuestion, new: Sequence[Seen], length: float) -> Iterator[FoundAnswer]:
    """The letter of what has come to light and is so long, if anything is."""
    none = none_of_them(asked.question)
    for seen in new:
        name = seen.name or ""
        letters = [letter for letter, text in asked.question.options if same(name, text)]
        if letters:
            yield FoundAnswer(letters[0], "so long", {"thing": name})
        elif none is not None and _cm(seen, asked.question.scale) > _SHORT * length:
            yield FoundAnswer(none, "so long none", {"thing": name})


def _called(search: Search, names: Sequence[str]) -> list[Seen]:
    return [seen for name in names for seen in search.graph.called(name)]


def _length_told(text: str) -> float:
    """The length in centimetres that a question tells; 0 if it tells none."""
    found = _LENGTH.search(text)
    return float(found[1]) if found else 0.0


def _cm(seen: Seen, scale: PictureScale) -> float:
    """The longer side of a thing's box in centimetres."""
    left, top, right, bottom = seen.box
    return (max(right - left, bottom - top) + 1) * 100 * scale.width / scale.side_px


PLAN = TypePlan(_begin)
