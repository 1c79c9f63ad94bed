"""Which of the things that show now is which of those that showed before, by their looks."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from scipy.optimize import linear_sum_assignment

from probe.changes.likeness import likeness
from probe.changes.sighting import Sighting

_ALIKE = 0.55
_HELD_BONUS = 0.15
_FAR, _FAR_COST = 0.3, 0.1


@dataclass(frozen=True, eq=False)
class Located:
    """A sighting, and where it was."""

    sighting: Sighting
    where: Literal["table", "basket", "beside"]


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


def not_found(
    before: Sequence[Located], after: Sequence[Located], found: Mapping[int, Located]
) -> tuple[Sequence[Located], Sequence[Located]]:
    """What is left of either, once some have been found."""
    taken = {id(other.sighting) for other in found.values()}
    left = [one for one in before if id(one.sighting) not in found]
    return left, [other for other in after if id(other.sighting) not in taken]


def found_among(earlier: Sequence[Sighting], now: Sequence[Sighting]) -> Mapping[int, Sighting]:
    """Which of the things seen at any earlier time show among some now, by id() of the earlier."""
    before = [Located(sighting, "basket") for sighting in earlier]
    after = [Located(sighting, "basket") for sighting in now]
    return {key: other.sighting for key, other in again(before, after, None).items()}


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
