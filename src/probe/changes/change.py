"""What became of each thing between two looks, as values."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from probe.changes.sighting import Sighting
from probe.types import Array

Fate = Literal["stayed", "moved", "turned", "basket", "beside", "covered", "lost"]
"""What became of a thing:

stayed: It is where it was, or within MOVED of it.
moved: It shows elsewhere on the table; see Change for whether it lies otherwise, too.
turned: Its middle is within MOVED of where it was, but it has turned or tipped over.
basket: It shows in the basket.
beside: It shows beside the basket, out of the fixed camera's picture.
covered: It no longer shows, and something has come over its place.
lost: It shows neither on the table nor in or beside the basket.
"""


@dataclass(frozen=True, eq=False)
class Change:
    """What became of one thing.

    Attributes:
        before: As it was seen on the table.
        fate: See Fate.
        after: As it is seen now; None if it isn't.
        shift: How its middle moved on the table, metres, shape (3,); zeros elsewhere.
        at_least: Whether it may have moved further, as it shows less of itself.
        doubtful: Of what is covered or lost: whether something that shows now may yet be it, or
            what a part belongs to.
        partly: Of what shows: whether that is much more or less of it than before, though the
            picture's edge doesn't cut it off.
        perhaps: Of what is doubtful: the only thing come to light that may be it, if there is one.
        turned: Of what moved or turned: whether it is seen to lie otherwise than before.
    """

    before: Sighting
    fate: Fate
    after: Sighting | None
    shift: Array
    doubtful: bool = False
    turned: bool = False
    at_least: bool = False
    perhaps: Sighting | None = None
    partly: bool = False

    @property
    def gone(self) -> bool:
        """Whether it isn't found anywhere."""
        return self.fate in ("lost", "covered")


@dataclass(frozen=True, eq=False)
class Changes:
    """What became of everything.

    Attributes:
        things: One change for each thing that the table showed before, in its order.
        newly_in_basket: Sightings in the basket that are like nothing that was seen before.
        maybe_in_basket: Sightings in the basket of which only a part shows, that may be of what was
            buried there.
        back_in_basket: Sightings in the basket of what was missing before.
        buried: What showed in the basket before or earlier, and doesn't now.
        missing: What showed on the table before or earlier, and isn't found.
    """

    things: tuple[Change, ...]
    newly_in_basket: tuple[Sighting, ...]
    maybe_in_basket: tuple[Sighting, ...] = ()
    back_in_basket: tuple[Sighting, ...] = ()
    buried: tuple[Sighting, ...] = ()
    missing: tuple[Sighting, ...] = ()

    def of(self, seen: Sighting) -> Change:
        """What became of one of the things that were seen before."""
        return next(change for change in self.things if change.before is seen)

    def but(self, seen: Sighting) -> tuple[Change, ...]:
        """What became of all others."""
        return tuple(change for change in self.things if change.before is not seen)
