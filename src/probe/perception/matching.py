"""Which thing an agent means by its words or by a place. Knows only what is visible."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from probe.perception.things import Thing
from probe.perception.tokens import GENERIC, SPATIAL, colour_match, head, is_colour, tokens

NEAR_PX = 25
"""A place this close to a thing still means it."""

_ENOUGH = 0.55
_COLOUR_WEIGHT = 1.0
_WORD_WEIGHT = 2.0
_NOUN_WEIGHT = 3.0
_DESCRIPTION_WORTH = 0.7
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
    """The thing that is meant, and others that the words fit as well."""

    thing: Thing
    others: tuple[Thing, ...] = ()


def match(description: str, things: Sequence[Thing]) -> Match | None:
    """The thing that free words ("red mug") or a place ("the thing at (512, 300)") mean.

    Articles don't matter; a colour that is named has to be there; "left", "top", "largest" and
    the like choose among things that fit equally well. A place decides alone.

    Returns:
        None if nothing that shows fits.
    """
    if place := place_in(description):
        return _at(*place, things)
    said = tokens(description)
    wanted = [word for word in said if word not in SPATIAL and word not in GENERIC]
    noun = head(description)
    if not wanted and any(word in SPATIAL for word in said):
        fits = [(1.0, thing) for thing in things]
    else:
        scored = [(_score(wanted, noun, thing), thing) for thing in things]
        fits = [(score, thing) for score, thing in scored if score >= _ENOUGH]
    if not fits:
        return None
    best = max(score for score, _ in fits)
    equal = [thing for score, thing in fits if score >= best - _AS_GOOD]
    choices = [SPATIAL[word] for word in said if word in SPATIAL]
    for choice in choices:
        equal.sort(key=_EXTREMES[choice])
    return Match(equal[0], () if choices else tuple(equal[1:]))


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


def _score(wanted: Sequence[str], noun: str | None, thing: Thing) -> float:
    """Weighted share of the wanted words that fit, 0 to 1; 0 if a wanted colour isn't there."""
    words = thing.words
    names = set(tokens(f"{words.name or ''} {words.category}"))
    described = set(tokens(words.description))
    colours = {token for colour in words.colours for token in tokens(colour)}
    weights, gained = 0.0, 0.0
    for word in wanted:
        if is_colour(word):
            worth = max((colour_match(word, c) for c in colours | names), default=0.0)
            if worth == 0.0 and word not in described:
                return 0.0
            weight = _COLOUR_WEIGHT
        else:
            worth = 1.0 if word in names else _DESCRIPTION_WORTH if word in described else 0.0
            weight = _NOUN_WEIGHT if word == noun else _WORD_WEIGHT
        weights, gained = weights + weight, gained + weight * worth
    return gained / weights if weights else 0.0
