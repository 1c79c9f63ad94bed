"""Which thing an agent means by its words or by a place. Knows only what is visible."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from probe.perception.fitting import Wanted, fits
from probe.perception.things import Thing
from probe.perception.tokens import SPATIAL, tokens

NEAR_PX = 25
"""A place this close to a thing still means it."""

NEAREST = 5
"""Things that are listed at most if none fits."""

_ENOUGH = 0.55
_RESEMBLES = 0.2
_AS_GOOD = 0.05

_NUMBER = r"(\d{1,6}(?:\.\d{1,6})?)"
_PLACE = re.compile(rf"(?:[(\[]\s*|\bat\s+){_NUMBER}\s*,\s*{_NUMBER}")
_EXTREMES: dict[str, Callable[[Thing], int]] = {
    "left": lambda t: t.point_px[0],
    "right": lambda t: -t.point_px[0],
    "top": lambda t: t.point_px[1],
    "bottom": lambda t: -t.point_px[1],
    "large": lambda t: -int(t.mask.sum()),
    "small": lambda t: int(t.mask.sum()),
}


@dataclass(frozen=True, eq=False)
class Match:
    """The thing that is meant.

    Attributes:
        thing: It.
        others: Those that the words fit as well.
        literal: Whether its own words say what was asked for; else it is what comes nearest.
    """

    thing: Thing
    others: tuple[Thing, ...] = ()
    literal: bool = True


def match(description: str, things: Sequence[Thing]) -> Match | None:
    """The thing that free words ("red mug") or a place ("the thing at (512, 300)") mean.

    Articles don't matter; a colour that is named has to be there; "left", "top", "largest" and
    the like choose among things that fit equally well. Other words for the same thing, or for one
    that looks alike, fit less well than its own. A place decides alone.

    Returns:
        None if nothing that shows fits.
    """
    if place := place_in(description):
        return _at(*place, things)
    said, wanted = tokens(description), Wanted.of(description)
    if not wanted.words and any(word in SPATIAL for word in said):
        scored = [(1.0, True, thing) for thing in things]
    else:
        found = zip(fits(wanted, [thing.words for thing in things]), things, strict=True)
        scored = [
            (fit.score, fit.literal, thing)
            for fit, thing in found
            if fit.allowed and fit.score >= _ENOUGH
        ]
    if not scored:
        return None
    best = max(score for score, _, _ in scored)
    equal = [(literal, thing) for score, literal, thing in scored if score >= best - _AS_GOOD]
    choices = [SPATIAL[word] for word in said if word in SPATIAL]
    for choice in choices:
        equal.sort(key=lambda each: _EXTREMES[choice](each[1]))
    literal, first = equal[0]
    return Match(first, () if choices else tuple(thing for _, thing in equal[1:]), literal)


def nearest(description: str, things: Sequence[Thing]) -> tuple[Thing, ...]:
    """Things that resemble what words describe, the most alike first; none for a place."""
    if place_in(description):
        return ()
    found = fits(Wanted.of(description), [thing.words for thing in things])
    alike = [(fit.score, thing) for fit, thing in zip(found, things, strict=True)]
    alike = [(score, thing) for score, thing in alike if score >= _RESEMBLES]
    alike.sort(key=lambda each: -each[0])
    return tuple(thing for _, thing in alike[:NEAREST])


def place_in(description: str) -> tuple[float, float] | None:
    """(u, v) of a place that a description gives in pixels ("the thing at (512, 300)")."""
    place = _PLACE.search(description)
    return (float(place[1]), float(place[2])) if place else None


def _at(u: float, v: float, things: Sequence[Thing]) -> Match | None:
    nearest, distance = None, NEAR_PX + 1.0
    for thing in things:
        rows, columns = np.nonzero(thing.mask)
        apart = float(np.hypot(columns - int(u), rows - int(v)).min())
        if apart < distance:
            nearest, distance = thing, apart
    return Match(nearest) if nearest and distance <= NEAR_PX else None
