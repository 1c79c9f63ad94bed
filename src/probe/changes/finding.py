"""Where things are that aren't where they were: whole ones by their looks, parts by their place."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from probe.changes.matching import Located, again, not_found
from probe.changes.parts import is_clear, may_lie_there, uncovered
from probe.changes.sighting import Sighting
from probe.types import Frame


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
    known = [it for it in before if it.sighting.thing.nameable or it.sighting is held]
    found = {**again(known, after, held)}
    found |= _by_name(*not_found(before, after, found))
    found |= uncovered(frame, *not_found(before, after, found))
    return {**found, **_by_looks(frame, *not_found(before, after, found), held)}


def _by_looks(
    frame: Frame, before: Sequence[Located], after: Sequence[Located], held: Sighting | None
) -> Mapping[int, Located]:
    """What was held, and parts that nothing but one thing can be."""
    found = again(before, after, held)
    _, new = not_found(before, after, found)
    return {
        id(one.sighting): other
        for one in before
        if (other := found.get(id(one.sighting))) is not None
        and (
            one.sighting is held
            or (is_clear(one, other, before, after) and not may_lie_there(frame, one, new))
        )
    }


def _by_name(before: Sequence[Located], after: Sequence[Located]) -> Mapping[int, Located]:
    """What shows another side of itself: of its name, it alone is missing, and one alone is new."""
    names = [one.sighting.thing.words.name for one in before]
    new = [other.sighting.thing.words.name for other in after]
    return {
        id(one.sighting): after[new.index(name)]
        for one, name in zip(before, names, strict=True)
        if name is not None
        and names.count(name) == new.count(name) == 1
        and one.where == after[new.index(name)].where == "table"
    }
