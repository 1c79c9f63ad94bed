"""How the scripted agent goes about Ranked: it lifts all like covers and compares what shows."""

from __future__ import annotations

from collections.abc import Sequence

from probe.agents.like_covers import LikeCovers
from probe.agents.moves import Plan
from probe.agents.phrases import Reason
from probe.agents.reading import Seen
from probe.agents.type_plan import ScriptedQuestion, TypePlan
from probe.agents.uncovering import FoundAnswer, answer_naming, conclude
from probe.question_types.ranked.rules import RANKS


def _begin(asked: ScriptedQuestion) -> Plan[None]:
    """Lift all covers, and go by the boxes of what has come to light."""
    covers = LikeCovers.of(asked)
    yield from covers.begin()
    best: dict[str, Seen] = {}
    found: FoundAnswer | None = None
    while covers.places:
        for seen in covers.newcomers:
            name = seen.name or ""
            # As it showed most of itself.
            if name not in best or seen.area > best[name].area:
                best[name] = seen
        if not covers.left:
            found = _ranked(asked, list(best.values())) if len(best) == covers.count else None
            break
        if not (yield from covers.clear_next(Reason("each cover"))):
            break
    yield from conclude(asked, found, covers.search)


def _ranked(asked: ScriptedQuestion, things: Sequence[Seen]) -> FoundAnswer | None:
    """The letter of what has the rank that is asked for; None if there is no letter to give."""
    order = sorted(things, key=_length, reverse=True)
    if len(order) != len(RANKS):
        return None
    name = order[RANKS.index(asked.form)].name or ""
    return answer_naming(asked.question, name, f"rank {asked.form}", {"thing": name})


def _length(seen: Seen) -> int:
    """The longer side of its box, in pixels.

    That is nearer to the length of an oblong thing than the diagonal, however the thing is turned.
    """
    left, top, right, bottom = seen.box
    return max(right - left, bottom - top)


PLAN = TypePlan(_begin)
