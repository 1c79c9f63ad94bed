"""Chooses who plays in a scene: what is hidden, what covers it, and all others. No physics."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.errors import Unsatisfiable
from probe.generation.alike import draw_alike, unlike
from probe.generation.covers import Cover, Footprint, footprint_of
from probe.generation.likeness import Likeness, longest
from probe.generation.result import Rejected
from probe.scene.sampling import DEFAULT_COUNT, draw_objects
from probe.tasks.options import CANDIDATES

SMALLEST, LARGEST = 0.025, 0.09
"""Longest side in metres of what may be hidden beneath a single thing."""

CAST_TRIES, VARIED_TRIES = 8, 4
"""Sets of alike things that are drawn until something covers each of them, and how many of these
are of several categories where that can be."""

LEADING = "own things"
"""Name of the check that things which are to play the parts do."""

LEAST_LEADING = 2
"""Of five candidates, fewer that lead would tell the answer, if it is to be one of them."""

CoverDraw = Callable[
    [Library, Sequence[ObjectSpec], Sequence[Footprint], np.random.Generator], Cover | None
]


@dataclass(frozen=True, eq=False)
class ObjectSelection:
    """Who plays in a scene: the candidates, what covers one of them, and all others.

    Attributes:
        candidates: Of which one is on the table.
        eligible: Indices of those of which that one is drawn; all, or those that lead.
        covers: The lowest first; at least one.
        others: The crowd, and last what lies on covers.
        beneath: What lies under further covers.
        topped: Covers, by number from 0, that each of the last of the others lies on.
    """

    candidates: tuple[ObjectSpec, ...]
    eligible: tuple[int, ...]
    covers: tuple[Cover, ...]
    others: tuple[ObjectSpec, ...]
    beneath: tuple[ObjectSpec, ...] = ()
    topped: tuple[int, ...] = ()

    def draw_true(self, rng: np.random.Generator) -> int:
        """Index of the candidate that is on the table."""
        return self.eligible[int(rng.integers(len(self.eligible)))]

    @property
    def specs(self) -> tuple[ObjectSpec, ...]:
        """All of them, in the order of their instances on a stage."""
        covers = (cover.spec for cover in self.covers)
        return (*self.candidates, *self.beneath, *covers, *self.others)

    @property
    def secrets(self) -> tuple[int, ...]:
        """Instances on a stage of what lies under further covers."""
        first = len(self.candidates) + 1
        return tuple(range(first, first + len(self.beneath)))

    @property
    def covering(self) -> tuple[int, ...]:
        """The covers' instances on a stage; what they hide comes before them."""
        first = len(self.candidates) + len(self.beneath) + 1
        return tuple(range(first, first + len(self.covers)))

    @property
    def crowd(self) -> tuple[int, ...]:
        """The crowd's instances on a stage."""
        return tuple(range(self.covering[-1] + 1, len(self.specs) - len(self.topped) + 1))

    @property
    def toppings(self) -> Mapping[int, int]:
        """What lies on covers, and on which: instances on a stage."""
        first = len(self.specs) - len(self.topped) + 1
        under = (self.covering[number] for number in self.topped)
        return dict(zip(range(first, len(self.specs) + 1), under, strict=True))


def hideable(library: Library, largest: float = LARGEST) -> list[ObjectSpec]:
    """Objects small enough to be hidden."""
    return [spec for spec in library.specs if SMALLEST <= longest(spec) <= largest]


def needs_alike(
    largest: float, tolerance: float, count: int = CANDIDATES, *, sides: bool = False
) -> str:
    """What things that could stand for one another are like, for people; metres, a share."""
    low, high = 100 * SMALLEST, 100 * largest
    what = "length, width and height" if sides else "length"
    alike = f"alike in {what} to {tolerance:.0%}, unlike in name and colour"
    return f"{count} things {low:g} to {high:g} cm long, {alike}"


def draw_cast(
    library: Library,
    pool: Sequence[ObjectSpec],
    draw_over: CoverDraw,
    likeness: Likeness,
    rng: np.random.Generator,
    count: int = DEFAULT_COUNT,
    draw_more: Sequence[CoverDraw] = (),
) -> ObjectSelection:
    """Draw five candidates, something to cover any of them, and the others.

    Args:
        library: To choose from.
        pool: What may be hidden; see hideable().
        draw_over: Draws the cover: draw_cover(), draw_lean() or draw_slab().
        likeness: How alike the candidates are.
        rng: Draws everything.
        count: Things on the table.
        draw_more: Draw what else lies there, on top.

    Raises:
        Rejected: The library has no such set.
    """
    failure = Rejected("cover", "nothing was drawn")
    for number in range(CAST_TRIES):
        candidates = draw_alike(
            pool,
            library.specs,
            likeness,
            CANDIDATES,
            rng,
            varied=likeness.sides is not None and number < VARIED_TRIES,
            leads=library.leads,
        )
        free = unlike(library.specs, candidates)
        room = [footprint_of(library, spec.id) for spec in candidates]
        covers: list[Cover] = []
        for draw in (draw_over, *draw_more):
            if not (cover := draw(library, free, room, rng)):
                number = f"{len(covers)} of {1 + len(draw_more)}"
                failure = Rejected("cover", f"only {number} covers for {_names(candidates)}")
                break
            covers.append(cover)
            free = unlike(free, [cover.spec])
        else:
            try:
                eligible = those_to_hide(library, candidates, covers)
            except Rejected as rejected:
                failure = rejected
                continue
            others = draw_crowd(free, count - 1 - len(covers), rng)
            return ObjectSelection(candidates, eligible, tuple(covers), others)
    raise failure


def _names(specs: Sequence[ObjectSpec]) -> str:
    return ", ".join(spec.name for spec in specs)


def those_to_hide(
    library: Library, candidates: Sequence[ObjectSpec], covers: Sequence[Cover]
) -> tuple[int, ...]:
    """Indices of the candidates of which one may be on the table; see ObjectSelection.

    Raises:
        Rejected: Some things lead, but none would play a part.
    """
    leading = [index for index, spec in enumerate(candidates) if library.leads(spec)]
    if len(leading) >= LEAST_LEADING:
        return tuple(leading)
    if library.leading and not any(library.leads(cover.spec) for cover in covers):
        played = f"{_names(candidates)} beneath {_names([cover.spec for cover in covers])}"
        raise Rejected(LEADING, f"{played}: fewer than {LEAST_LEADING} of them are of your own")
    return tuple(range(len(candidates)))


def draw_crowd(
    free: Sequence[ObjectSpec], count: int, rng: np.random.Generator
) -> tuple[ObjectSpec, ...]:
    """Draw the things that matter to no rule, largest first.

    Raises:
        Rejected: The library has too few.
    """
    try:
        drawn = draw_objects(free, count, rng)
    except Unsatisfiable as failure:
        raise Rejected("crowd", str(failure)) from failure
    return tuple(sorted(drawn, key=lambda spec: math.prod(spec.size), reverse=True))
