"""From two looks to what became of each thing that was seen before. Knows no truth, no words."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from probe.changes.basket import with_earlier, with_held
from probe.changes.change import Change, Changes, Fate
from probe.changes.finding import found_again
from probe.changes.matching import Located, not_found
from probe.changes.parts import may_be, only_like
from probe.changes.places import (
    covered,
    has_turned,
    hidden_otherwise,
    is_cut_off,
    least_shift,
)
from probe.changes.rest import AtRest, at_rest
from probe.changes.sighting import Look, Sighting
from probe.changes.turning import lies_otherwise
from probe.manipulation.looking import still_there, tracked
from probe.types import Array

MOVED = 0.015
"""Metres from which on a thing counts as moved. Less than 3 cm, from where on it matters: when a
thing rolls or tips, the middle of what shows goes less far than the thing."""

_STILL, _COMMON = 0.5, 0.2
_SAME_AREA = (0.8, 1.25)


def compare(before: Look, after: Look, held: Sighting | None = None) -> Changes:
    """Find again what was seen before.

    What stands where it stood is known by its place. The rest is matched by looks, all at once,
    so that two like things are never both taken for one.

    Args:
        before: The first look.
        after: The second look.
        held: Of the first look: what the fingers felt until they let go over the basket.
    """
    here = _at_rest(before, after)
    stayed = {
        id(before.things[one]): None if other is None else after.things[other]
        for one, other in here.stayed.items()
    }
    lone, new = _without(before, after, here)
    found = found_again(before.table, lone, new, held)
    left, rest = not_found(lone, new, found)
    changes = tuple(
        Change(sighting, "stayed", stayed[id(sighting)], np.zeros(3))
        if id(sighting) in stayed
        else _elsewhere(before, after, sighting, found[id(sighting)])
        if id(sighting) in found
        else _gone(before, after, sighting, new, left, rest)
        for sighting in before.things
    )
    in_basket = tuple(other.sighting for other in rest if other.where == "basket")
    arrived = tuple(other.sighting for other in new if other.where == "basket")
    things, in_basket = with_held(changes, in_basket, held, arrived if before.guessed else ())
    return with_earlier(before, things, left, rest, in_basket)


def _at_rest(before: Look, after: Look) -> AtRest:
    tables, things = (before.table, after.table), (before.things, after.things)
    return at_rest(*tables, *things, guessed=before.guessed)


def _without(
    before: Look, after: Look, here: AtRest
) -> tuple[Sequence[Located], Sequence[Located]]:
    """What isn't known by its place, of each look."""
    baskets, guessed = (before.basket, after.basket), before.guessed
    below = at_rest(*baskets, before.in_basket, after.in_basket, guessed=guessed)
    beside = at_rest(*baskets, before.beside, after.beside, guessed=guessed)
    lone = [
        *(Located(s, "table") for n, s in enumerate(before.things) if n not in here.stayed),
        *(Located(s, "basket") for n, s in enumerate(before.in_basket) if n not in below.stayed),
        *(Located(s, "beside") for n, s in enumerate(before.beside) if n not in beside.stayed),
    ]
    new = [
        *(Located(s, "table") for n, s in enumerate(after.things) if n not in here.known),
        *(Located(s, "basket") for n, s in enumerate(after.in_basket) if n not in below.known),
        *(Located(s, "beside") for n, s in enumerate(after.beside) if n not in beside.known),
    ]
    return lone, new


def _gone(
    before: Look,
    after: Look,
    one: Sighting,
    new: Sequence[Located],
    left: Sequence[Located],
    rest: Sequence[Located],
) -> Change:
    """What became of something that wasn't found again, and what it may be of what is new.

    Args:
        before: The first look.
        after: The second look.
        one: Of the first look.
        new: All that isn't known by its place.
        left: All that wasn't found again.
        rest: Of what is new, what was taken for nothing.
    """
    mask = one.thing.mask
    if still_there(before.table, after.table, mask) > _STILL:
        return Change(one, "stayed", None, np.zeros(3))
    fate: Fate = "covered" if covered(before.table, after.table, mask) else "lost"
    like = any(may_be(one, it.sighting) for it in new)
    # A lid is of another colour than its pot: a part may belong to whatever came to light.
    lid = not one.thing.nameable and any(it.where == "table" for it in rest)
    # Where outlines are guessed, it may be in one piece with its neighbour now.
    doubtful = before.guessed or like or lid
    perhaps = only_like(one, left, rest)
    return Change(one, fate, None, np.zeros(3), doubtful, perhaps=perhaps)


def _elsewhere(before: Look, after: Look, one: Sighting, other: Located) -> Change:
    """What became of something that was found again, though not by its place."""
    if other.where != "table":
        return Change(one, other.where, other.sighting, np.zeros(3))
    shift, at_least = _shift(before, after, one, other.sighting)
    moved = float(np.linalg.norm(shift)) >= MOVED
    shown = (before.table, after.table, one.thing.mask, other.sighting.thing.mask)
    # Of what showed only in part, nothing tells whether it has turned or come to light.
    turned = one.thing.nameable and (moved or has_turned(*shown)) and lies_otherwise(*shown)
    fate = "moved" if moved else "turned" if turned else "stayed"
    partly = not _as_large(one, other.sighting) and not is_cut_off(other.sighting.thing.mask)
    return Change(one, fate, other.sighting, shift, turned=turned, at_least=at_least, partly=partly)


def _as_large(one: Sighting, other: Sighting) -> bool:
    low, high = _SAME_AREA
    return low < other.area / one.area < high


def _shift(before: Look, after: Look, one: Sighting, other: Sighting) -> tuple[Array, bool]:
    """How far a thing has gone, and whether that is the least that it may have.

    Its middle won't do if it shows more, less or another part of itself now.
    """
    middle, (was, now) = other.middle - one.middle, (one.thing.mask, other.thing.mask)
    if np.linalg.norm(middle) < MOVED:
        return middle, False
    # A heap that is pushed takes along what hides a thing; of a part, its place alone tells little.
    common = _COMMON if one.thing.nameable else 0.0
    if hidden_otherwise(before.table, after.table, was, now, common):
        return np.zeros(3), False
    if not one.thing.nameable:
        return middle, True
    if _as_large(one, other):
        return middle, is_cut_off(now)
    least = least_shift(before.table, was, now)
    found = tracked(before.table, after.table, was, middle, now)
    if found is None or np.linalg.norm(least) < np.linalg.norm(found.shift):
        return least, True
    return found.shift, is_cut_off(now)
