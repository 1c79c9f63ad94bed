"""From two looks to what became of each thing that was seen before. Knows no truth, no words."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from probe.changes.likeness import likeness
from probe.changes.matching import Located, again, may_be
from probe.changes.places import covered, has_turned, unmoved
from probe.changes.sighting import Look, Sighting
from probe.manipulation.looking import still_there, tracked
from probe.types import Array

Fate = Literal["stayed", "moved", "turned", "basket", "beside", "covered", "lost"]
"""What became of a thing:

stayed: It is where it was, or within MOVED of it.
moved: It shows elsewhere on the table.
turned: Its middle is within MOVED of where it was, but it has turned or tipped over.
basket: It shows in the basket.
beside: It shows beside the basket, out of the fixed camera's picture.
covered: It no longer shows, and something has come over its place.
lost: It shows neither on the table nor in or beside the basket.
"""

MOVED = 0.015
"""Metres from which on a thing counts as moved. Less than 3 cm, from where on it matters: when a
thing rolls or tips, the middle of what shows goes less far than the thing."""

_STILL = 0.5
_SAME_AREA = (0.8, 1.25)


@dataclass(frozen=True, eq=False)
class Change:
    """What became of one thing.

    Attributes:
        before: As it was seen on the table.
        fate: See Fate.
        after: As it is seen now; None if it isn't.
        shift: How its middle moved on the table, metres, shape (3,); zeros elsewhere.
        doubtful: Of what is covered or lost: whether something that shows now may yet be it.
    """

    before: Sighting
    fate: Fate
    after: Sighting | None
    shift: Array
    doubtful: bool = False


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
    stayed = {id(before.things[one]): after.things[other] for one, other in here.items()}
    lone, new = _without(before, after, here)
    found = again(lone, new, held)
    taken = {id(other.sighting) for other in found.values()}
    changes = tuple(
        Change(sighting, "stayed", stayed[id(sighting)], np.zeros(3))
        if id(sighting) in stayed
        else _gone(before, after, sighting, found.get(id(sighting)), new)
        for sighting in before.things
    )
    rest = [s.sighting for s in new if s.where == "basket" and id(s.sighting) not in taken]
    return _with_held(Changes(changes, tuple(rest)), held)


def _without(
    before: Look, after: Look, here: Mapping[int, int]
) -> tuple[Sequence[Located], Sequence[Located]]:
    """What isn't known by its place, of each look."""
    below = unmoved(before.basket, after.basket, before.in_basket, after.in_basket)
    beside = unmoved(before.basket, after.basket, before.beside, after.beside)
    lone = [
        *(Located(s, "table") for n, s in enumerate(before.things) if n not in here),
        *(Located(s, "basket") for n, s in enumerate(before.in_basket) if n not in below),
        *(Located(s, "beside") for n, s in enumerate(before.beside) if n not in beside),
    ]
    new = [
        *(Located(s, "table") for n, s in enumerate(after.things) if n not in here.values()),
        *(Located(s, "basket") for n, s in enumerate(after.in_basket) if n not in below.values()),
        *(Located(s, "beside") for n, s in enumerate(after.beside) if n not in beside.values()),
    ]
    return lone, new


def _gone(
    before: Look, after: Look, one: Sighting, other: Located | None, new: Sequence[Located]
) -> Change:
    """What became of something that isn't known by its place."""
    if other is None:
        mask = one.thing.mask
        if still_there(before.table, after.table, mask) > _STILL:
            return Change(one, "stayed", None, np.zeros(3))
        fate: Fate = "covered" if covered(before.table, after.table, mask) else "lost"
        return Change(one, fate, None, np.zeros(3), any(may_be(one, s.sighting) for s in new))
    if other.where != "table":
        return Change(one, other.where, other.sighting, np.zeros(3))
    shift = _shift(before, after, one, other.sighting)
    if float(np.linalg.norm(shift)) >= MOVED:
        return Change(one, "moved", other.sighting, shift)
    turned = has_turned(before.table, after.table, one.thing.mask, other.sighting.thing.mask)
    return Change(one, "turned" if turned else "stayed", other.sighting, shift)


def _with_held(changes: Changes, held: Sighting | None) -> Changes:
    """With what was held in the basket, if it must be there though its looks don't tell.

    Something new lies in the basket, the thing shows nowhere, and nothing else has vanished.
    """
    vanished = [change for change in changes.things if change.fate in ("lost", "covered")]
    if held is None or not changes.newly_in_basket or [c.before for c in vanished] != [held]:
        return changes
    it = max(changes.newly_in_basket, key=lambda other: likeness(held, other))
    found = replace(vanished[0], fate="basket", after=it, doubtful=False)
    things = tuple(found if change is vanished[0] else change for change in changes.things)
    return Changes(things, tuple(s for s in changes.newly_in_basket if s is not it))


def _shift(before: Look, after: Look, one: Sighting, other: Sighting) -> Array:
    """How far a thing has gone; its middle won't do if it shows more or less of itself now."""
    middle = other.middle - one.middle
    low, high = _SAME_AREA
    if np.linalg.norm(middle) < MOVED or low < other.area / one.area < high:
        return middle
    found = tracked(before.table, after.table, one.thing.mask, middle, other.thing.mask)
    return middle if found is None else found.shift
