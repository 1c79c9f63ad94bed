"""Which of the things that show now is which of those that showed before, by their looks."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from scipy.optimize import linear_sum_assignment

from probe.changes.likeness import likeness
from probe.changes.places import about_there
from probe.changes.sighting import Sighting
from probe.manipulation.palette import agreement
from probe.types import Frame

_ALIKE = 0.55
_HELD_BONUS = 0.15
_FAR, _FAR_COST = 0.3, 0.1
_HINT = 0.2
"""Agreement of colours from which on a part of something may be a part of a thing."""


@dataclass(frozen=True, eq=False)
class Located:
    """A sighting, and where it was."""

    sighting: Sighting
    where: Literal["table", "basket", "beside"]


def found_again(
    frame: Frame, before: Sequence[Located], after: Sequence[Located], held: Sighting | None
) -> Mapping[int, Located]:
    """What was found again, by the id() of the earlier sighting: by its looks, and parts by place.

    What a part belongs to shows best where the part was; looks alone would give it to any like one.

    Args:
        frame: The table before.
        before: What isn't where it was.
        after: What wasn't where it is.
        held: What the fingers felt until they let go over the basket.
    """
    found = {**again([one for one in before if one.sighting.thing.nameable], after, held)}
    found |= uncovered(frame, before, after, found)
    taken = {id(other.sighting) for other in found.values()}
    left = [one for one in before if id(one.sighting) not in found]
    return found | {**again(left, [it for it in after if id(it.sighting) not in taken], held)}


def again(
    before: Sequence[Located], after: Sequence[Located], held: Sighting | None
) -> Mapping[int, Located]:
    """What was found again by its looks, all at once, by the id() of the earlier sighting."""
    costs = np.array([[_cost(one, other, held) for other in after] for one in before])
    costs = costs.reshape(len(before), len(after))
    rows, columns = linear_sum_assignment(costs)
    return {
        id(before[row].sighting): after[column]
        for row, column in zip(rows.tolist(), columns.tolist(), strict=True)
        if costs[row, column] < 1 - _ALIKE
    }


def found_among(earlier: Sequence[Sighting], now: Sequence[Sighting]) -> Mapping[int, Sighting]:
    """Which of the things seen at any earlier time show among some now, by id() of the earlier."""
    before = [Located(sighting, "basket") for sighting in earlier]
    after = [Located(sighting, "basket") for sighting in now]
    return {key: other.sighting for key, other in again(before, after, None).items()}


def uncovered(
    frame: Frame,
    before: Sequence[Located],
    after: Sequence[Located],
    found: Mapping[int, Located],
) -> Mapping[int, Located]:
    """What came to light of things of which a part showed, and that weren't found otherwise.

    Several parts may have been of one thing.

    Args:
        frame: The table before.
        before: What isn't where it was.
        after: What wasn't where it is.
        found: What was found of it.
    """
    taken = {id(other.sighting) for other in found.values()}
    whole = [o for o in after if o.where == "table" and id(o.sighting) not in taken]
    more: dict[int, Located] = {}
    for one in before:
        part = one.sighting
        if one.where != "table" or part.thing.nameable or id(part) in found:
            continue
        around = [
            other
            for other in whole
            if may_be(part, other.sighting)
            and about_there(frame, part.thing.mask, other.sighting.thing.mask)
        ]
        if around:
            more[id(part)] = max(around, key=lambda o: agreement(part.colours, o.sighting.colours))
    return more


def may_be(one: Sighting, other: Sighting) -> bool:
    """Whether a thing may yet be one that wasn't taken for it.

    Of one of the two only a part shows, so that names and sizes don't tell, and colours agree.
    """
    partly = one.thing.words.name is None or other.thing.words.name is None
    return partly and agreement(one.colours, other.colours) >= _HINT


def _cost(one: Located, other: Located, held: Sighting | None) -> float:
    """Cost of taking one for the other; nothing leaves the basket."""
    if one.where == "basket" != other.where:
        return 1.0
    cost = 1 - likeness(one.sighting, other.sighting)
    if other.where == "basket" and one.sighting is held:
        cost -= _HELD_BONUS
    if one.where == other.where == "table":
        apart = float(np.linalg.norm(one.sighting.middle - other.sighting.middle))
        cost += _FAR_COST * min(1.0, apart / _FAR)
    return cost
