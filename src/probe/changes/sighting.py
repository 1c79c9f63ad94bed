"""Things as they were seen at one time, on the table and in the basket. Knows no identities."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from probe.manipulation.palette import histogram
from probe.manipulation.terrain import lifted
from probe.perception.things import Thing
from probe.types import Array, Frame


@dataclass(frozen=True, eq=False)
class Sighting:
    """One thing as it was seen once.

    Attributes:
        thing: What perception made of it.
        middle: Mean of its visible points, world, metres, shape (3,).
        area: Of what shows of it, seen along the camera's rays, square metres.
        colours: Histogram of its visible pixels that adds up to 1, shape (8, 32, 32).
    """

    thing: Thing
    middle: Array
    area: float
    colours: Array


@dataclass(frozen=True, eq=False)
class Look:
    """All that was seen at one time.

    Attributes:
        table: The fixed camera's frame, with colours.
        things: What it shows.
        basket: The frame of the camera above the basket, with colours.
        in_basket: What that one shows between the basket's walls.
        beside: What it shows outside of them, and the table's frame doesn't.
        guessed: Whether the same thing may be outlined otherwise next time: in two pieces, or in
            one with its neighbour.
        buried: Of earlier looks: what showed in the basket, and doesn't now.
        missing: Of earlier looks: what showed on the table, and hasn't been found since.
    """

    table: Frame
    things: tuple[Sighting, ...]
    basket: Frame
    in_basket: tuple[Sighting, ...]
    beside: tuple[Sighting, ...] = ()
    guessed: bool = False
    buried: tuple[Sighting, ...] = ()
    missing: tuple[Sighting, ...] = ()


def sightings(frame: Frame, things: Sequence[Thing]) -> tuple[Sighting, ...]:
    """The things of a frame that has colours, in their order."""
    return tuple(_sighting(frame, thing) for thing in things)


def including(look: Look, thing: Thing) -> tuple[Look, Sighting]:
    """The look with a thing that may be none of those seen, and its sighting.

    One that was pointed at takes the place of whatever it covers most of.
    """
    for sighting in look.things:
        if sighting.thing is thing:
            return look, sighting
    added = _sighting(look.table, thing)
    others = tuple(s for s in look.things if not _mostly_in(s.thing.mask, thing.mask))
    return replace(look, things=(*others, added)), added


def _mostly_in(mask: Array, other: Array) -> bool:
    return bool(2 * np.count_nonzero(mask & other) > np.count_nonzero(mask))


def _sighting(frame: Frame, thing: Thing) -> Sighting:
    assert frame.rgb is not None
    edge = frame.depth[thing.mask].astype(float) / frame.camera.focal_px
    return Sighting(
        thing,
        lifted(frame, thing.mask).mean(axis=0),
        float(np.sum(edge**2)),
        histogram(frame.rgb, thing.mask),
    )
