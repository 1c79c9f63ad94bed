"""Which thing an agent means by its words or by a place. Knows only what is visible."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from probe.perception.called import nouns
from probe.perception.fitting import Fit, fits
from probe.perception.phrase import SPATIAL, VAGUE
from probe.perception.places import EXTREMES, place_in, thing_at
from probe.perception.things import Thing
from probe.perception.tokens import tokens
from probe.perception.wanted import Wanted

NEAREST = 5
"""Things that are listed at most if none fits, or besides the one that is found."""

MOST_EQUALS = 4
"""Things that are listed at most because they fit as well as the one that is found."""

_ENOUGH = 0.55
_RESEMBLES = 0.2
_AS_GOOD = 0.05
_WRONG_COLOUR = 0.8
"""What is left of a score where no colour fits: people name colours better than things."""

Fitting = tuple[Fit, Thing]


@dataclass(frozen=True, eq=False)
class Match:
    """The thing that is meant.

    Attributes:
        thing: It.
        others: Those that the words fit as well.
        maybe: Others that may be meant, the most alike first; none if all words fit and one of
            them says what it is.
        literal: Whether its own words say what was asked for; else it is what comes nearest.
        whole: Whether all the words fit.
    """

    thing: Thing
    others: tuple[Thing, ...] = ()
    maybe: tuple[Thing, ...] = ()
    literal: bool = True
    whole: bool = True


def match(description: str, things: Sequence[Thing]) -> Match | None:
    """The thing that free words ("red mug") or a place ("the thing at (512, 300)") mean.

    Articles don't matter; a colour that is named has to be there; "left", "top", "largest" and
    the like choose among things that fit equally well. Other words for the same thing, or for one
    that looks alike, fit less well than its own. A place decides alone.

    Returns:
        None if nothing that shows fits.
    """
    if place := place_in(description):
        thing = thing_at(*place, things)
        return Match(thing) if thing else None
    wanted, choices = _read(description, things)
    fitted = _fitted(wanted, things)
    anything = not wanted.words and bool(choices)
    scored = fitted if anything else [each for each in fitted if _enough(each[0])]
    if not scored:
        return None
    best = max(fit.score for fit, _ in scored)
    equal = [each for each in scored if each[0].score >= best - _AS_GOOD]
    for word in choices:
        equal.sort(key=_extreme(word))
    (fit, first), *others = equal
    chosen = any(word not in VAGUE for word in choices)
    as_good = () if chosen else tuple(thing for _, thing in others[:MOST_EQUALS])
    told = (first, *(thing for _, thing in others))
    sure = anything or (fit.whole and wanted.noun is not None)
    maybe = () if sure else _ranked(fitted, told)
    return Match(first, as_good, maybe[: NEAREST - len(as_good)], fit.literal, fit.whole)


def nearest(description: str, things: Sequence[Thing]) -> tuple[Thing, ...]:
    """Things that resemble what words describe, the most alike first; none for a place.

    Things that can't be named may be anything of their colours.
    """
    if place_in(description):
        return ()
    wanted, _ = _read(description, things)
    if not wanted.words:
        return ()
    return _ranked(_fitted(wanted, things))[:NEAREST]


def _read(description: str, things: Sequence[Thing]) -> tuple[Wanted, list[str]]:
    """What words ask for, and the spatial ones among them in their order."""
    named = {noun for thing in things for noun in nouns(thing.words)}
    wanted = Wanted.of(description, SPATIAL.keys() & named)
    choices = [word for word in tokens(description) if word in SPATIAL and word != wanted.noun]
    return wanted, choices


def _fitted(wanted: Wanted, things: Sequence[Thing]) -> list[Fitting]:
    return list(zip(fits(wanted, [thing.words for thing in things]), things, strict=True))


def _enough(fit: Fit) -> bool:
    return fit.allowed and fit.like and fit.score >= _ENOUGH


def _extreme(word: str) -> Callable[[Fitting], int]:
    least = EXTREMES[SPATIAL[word]]
    return lambda each: least(each[1])


def _ranked(fitted: Sequence[Fitting], told: Sequence[Thing] = ()) -> tuple[Thing, ...]:
    """Things by their score, then by how much of them shows, without those that are told."""
    alike = [
        (fit.score if fit.allowed else _WRONG_COLOUR * fit.score, int(thing.mask.sum()), thing)
        for fit, thing in fitted
        if thing not in told and (fit.score >= _RESEMBLES if thing.nameable else fit.allowed)
    ]
    alike.sort(key=lambda each: (-each[0], -each[1]))
    return tuple(thing for _, _, thing in alike)
