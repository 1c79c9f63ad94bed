"""From two looks to what became of each thing that was seen before. Knows no truth, no words."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
from scipy.optimize import linear_sum_assignment

from probe.changes.likeness import likeness
from probe.changes.places import covered, unmoved
from probe.changes.sighting import Look, Sighting
from probe.manipulation.looking import still_there, tracked
from probe.types import Array

Fate = Literal["stayed", "moved", "basket", "covered", "lost"]
"""What became of a thing:

stayed: It is where it was, or within MOVED of it.
moved: It shows elsewhere on the table.
basket: It shows in the basket.
covered: It no longer shows, and something has come over its place.
lost: It shows neither on the table nor in the basket.
"""

MOVED = 0.02
"""Metres from which on a thing counts as moved. Less than 3 cm, from where on it matters: when a
thing rolls or tips, the middle of what shows goes less far than the thing."""

_STILL = 0.5
_ALIKE = 0.55
_HELD_BONUS = 0.15
_FAR, _FAR_COST = 0.3, 0.1
_SAME_AREA = (0.8, 1.25)


@dataclass(frozen=True, eq=False)
class Change:
    """What became of one thing.

    Attributes:
        before: As it was seen on the table.
        fate: See Fate.
        after: As it is seen now, on the table or in the basket; None if it isn't.
        shift: How its middle moved on the table, metres, shape (3,); zeros elsewhere.
    """

    before: Sighting
    fate: Fate
    after: Sighting | None
    shift: Array


@dataclass(frozen=True, eq=False)
class Changes:
    """What became of everything.

    Attributes:
        things: One change for each thing that the table showed before, in its order.
        newly_in_basket: Sightings in the basket that are like nothing that was seen before.
    """

    things: tuple[Change, ...]
    newly_in_basket: tuple[Sighting, ...]

    def of(self, seen: Sighting) -> Change:
        """What became of one of the things that were seen before."""
        return next(change for change in self.things if change.before is seen)

    def but(self, seen: Sighting) -> tuple[Change, ...]:
        """What became of all others."""
        return tuple(change for change in self.things if change.before is not seen)


def compare(before: Look, after: Look, held: Sighting | None = None) -> Changes:
    """Find again what was seen before.

    What stands where it stood is known by its place. The rest is matched by looks, all at once,
    so that two like things are never both taken for one.

    Args:
        before: The first look.
        after: The second look.
        held: Of the first look: what the fingers felt until they let go over the basket.
    """
    here = unmoved(before.table, after.table, before.things, after.things)
    below = unmoved(before.basket, after.basket, before.in_basket, after.in_basket)
    lone = [s for n, s in enumerate(before.things) if n not in here]
    lone_below = [s for n, s in enumerate(before.in_basket) if n not in below]
    new = [s for n, s in enumerate(after.things) if n not in here.values()]
    new_below = [s for n, s in enumerate(after.in_basket) if n not in below.values()]
    costs = _costs(lone, lone_below, new, new_below, held)
    rows, columns = linear_sum_assignment(costs)
    found = [
        (int(row), int(column))
        for row, column in zip(rows, columns, strict=True)
        if costs[row, column] < 1 - _ALIKE
    ]
    again = {id(lone[row]): column for row, column in found if row < len(lone)}
    changes: list[Change] = []
    for number, sighting in enumerate(before.things):
        column = again.get(id(sighting))
        if number in here:
            changes.append(_stayed(sighting, after.things[here[number]]))
        elif column is None:
            changes.append(_unseen(before, after, sighting))
        elif column >= len(new):
            changes.append(Change(sighting, "basket", new_below[column - len(new)], np.zeros(3)))
        else:
            changes.append(_elsewhere(before, after, sighting, new[column]))
    taken = {column - len(new) for _, column in found}
    rest = tuple(s for number, s in enumerate(new_below) if number not in taken)
    return Changes(tuple(changes), rest)


def _costs(
    lone: Sequence[Sighting],
    lone_below: Sequence[Sighting],
    new: Sequence[Sighting],
    new_below: Sequence[Sighting],
    held: Sighting | None,
) -> Array:
    """Cost of taking each for each, shape (before, after); nothing leaves the basket."""
    costs = np.ones((len(lone) + len(lone_below), len(new) + len(new_below)))
    for row, one in enumerate((*lone, *lone_below)):
        for column, other in enumerate((*new, *new_below)):
            to_basket = column >= len(new)
            if row >= len(lone) and not to_basket:
                continue
            cost = 1 - likeness(one, other)
            if to_basket and one is held:
                cost -= _HELD_BONUS
            if not to_basket:
                apart = float(np.linalg.norm(one.middle - other.middle))
                cost += _FAR_COST * min(1.0, apart / _FAR)
            costs[row, column] = cost
    return costs


def _stayed(one: Sighting, other: Sighting | None) -> Change:
    return Change(one, "stayed", other, np.zeros(3))


def _unseen(before: Look, after: Look, one: Sighting) -> Change:
    mask = one.thing.mask
    if still_there(before.table, after.table, mask) > _STILL:
        return _stayed(one, None)
    fate: Fate = "covered" if covered(before.table, after.table, mask) else "lost"
    return Change(one, fate, None, np.zeros(3))


def _elsewhere(before: Look, after: Look, one: Sighting, other: Sighting) -> Change:
    shift = _shift(before, after, one, other)
    near = float(np.linalg.norm(shift)) < MOVED
    return Change(one, "stayed" if near else "moved", other, shift)


def _shift(before: Look, after: Look, one: Sighting, other: Sighting) -> Array:
    """How far a thing has gone; its middle won't do if it shows more or less of itself now."""
    middle = other.middle - one.middle
    low, high = _SAME_AREA
    if np.linalg.norm(middle) < MOVED or low < other.area / one.area < high:
        return middle
    found = tracked(before.table, after.table, one.thing.mask, middle, other.thing.mask)
    return middle if found is None else found.shift
