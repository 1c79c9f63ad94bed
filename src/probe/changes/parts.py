"""What a part that showed of something may belong to, by its place and its colours."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from probe.changes.matching import Located
from probe.changes.places import about_there
from probe.changes.sighting import Sighting
from probe.manipulation.palette import agreement
from probe.types import Frame

_CLEAR = 0.3
"""By how much more than with any other colours have to agree to tell what a part is by them."""
_HINT = 0.2
"""Agreement of colours from which on a part of something may be a part of a thing."""


def uncovered(
    frame: Frame, before: Sequence[Located], after: Sequence[Located]
) -> Mapping[int, Located]:
    """What came to light of things of which a part showed.

    Several parts may have been of one thing.

    Args:
        frame: The table before.
        before: What wasn't found again so far.
        after: What is new and was taken for nothing so far.
    """
    whole = [other for other in after if other.where == "table"]
    more: dict[int, Located] = {}
    for one in before:
        part = one.sighting
        if one.where != "table" or part.thing.nameable:
            continue
        best = max((_agreement(one, other) for other in whole), default=0.0)
        around = [
            other
            for other in whole
            if _agreement(one, other) > max(0.0, best - _CLEAR)
            and about_there(frame, part.thing.mask, other.sighting.thing.mask)
        ]
        if around:
            more[id(part)] = max(around, key=lambda other: _agreement(one, other))
    return more


def may_be(one: Sighting, other: Sighting) -> bool:
    """Whether a thing may yet be one that wasn't taken for it.

    Of one of the two only a part shows, so that names and sizes don't tell, and colours agree.
    """
    partly = one.thing.words.name is None or other.thing.words.name is None
    return partly and may_be_piece(one, other)


def may_be_piece(one: Sighting, other: Sighting) -> bool:
    """Whether what was outlined as a thing of its own may be a piece of another, by its colours."""
    return agreement(one.colours, other.colours) >= _HINT


def only_like(
    one: Sighting, before: Sequence[Located], after: Sequence[Located]
) -> Sighting | None:
    """The only thing on the table that a part may be, if no other part may be that thing, too.

    Args:
        one: The part.
        before: What wasn't found again.
        after: What is new and was taken for nothing.
    """
    like = [it for it in after if it.where == "table" and may_be(one, it.sighting)]
    if len(like) != 1:
        return None
    other = like[0].sighting
    rivals = [it.sighting for it in before if it.where == "table" and it.sighting is not one]
    return None if any(may_be(rival, other) for rival in rivals) else other


def is_clear(
    one: Located, other: Located, before: Sequence[Located], after: Sequence[Located]
) -> bool:
    """Whether looks alone tell what a part on the table is: nothing else there comes near it.

    Args:
        one: The part.
        other: What looks most like it.
        before: All that wasn't found again so far.
        after: All that is new and was taken for nothing so far.
    """
    if not one.where == other.where == "table":
        return True
    rivals = [_agreement(one, it) for it in after if it is not other]
    rivals += [_agreement(it, other) for it in before if it is not one]
    return max(rivals, default=0.0) <= _agreement(one, other) - _CLEAR


def may_lie_there(frame: Frame, one: Located, new: Sequence[Located]) -> bool:
    """Whether something new on the table lies where a part was, and may be what it belongs to.

    Args:
        frame: The table before.
        one: The part.
        new: What was taken for nothing.
    """
    mask = one.sighting.thing.mask
    return any(
        _agreement(one, other) > 0 and about_there(frame, mask, other.sighting.thing.mask)
        for other in new
        if one.where == other.where == "table"
    )


def _agreement(one: Located, other: Located) -> float:
    """Of colours, where one may be the other."""
    if not may_be(one.sighting, other.sighting):
        return 0.0
    return agreement(one.sighting.colours, other.sighting.colours)
