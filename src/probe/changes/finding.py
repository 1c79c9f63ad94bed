"""Where things are that aren't where they were: whole ones by their looks, parts by their place."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from probe.changes.matching import Located, again
from probe.changes.parts import is_clear, uncovered
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
    found = {**again([one for one in before if one.sighting.thing.nameable], after, held)}
    found |= uncovered(frame, before, after, found)
    taken = {id(other.sighting) for other in found.values()}
    left = [one for one in before if id(one.sighting) not in found]
    rest = [it for it in after if id(it.sighting) not in taken]
    by_looks = again(left, rest, held)
    for one in left:
        other = by_looks.get(id(one.sighting))
        if other is not None and (one.sighting is held or is_clear(one, other, left, rest)):
            found[id(one.sighting)] = other
    return found
