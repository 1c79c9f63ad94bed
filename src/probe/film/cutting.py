"""From footage to a list of shots: idle time cut, slow where fingers close. Knows no pixels."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from probe.episodes.turns import Question
from probe.film.footage import FilmedCall, Footage
from probe.film.watched_world import SAMPLE_TIME, TableMoment
from probe.types import Array

FPS = 25
"""Frames a second of a film."""

SLOW = 0.5
"""Speed at which fingers are shown that close on something, of life's."""

_STILL_RAD, _STILL_M = 2e-4, 2e-4
"""What a joint, a finger or an object moves at most between two moments of rest."""

_CLOSING_M = 3e-4
"""What the pads approach each other at least between two moments while they close."""

_PARKED_RAD = 0.02
"""How far from where it is parked each joint stands at most when the arm counts as parked."""

_AROUND = 0.35
"""Simulated seconds before and after closing that are shown as slowly: it takes 0.1 s itself."""

_BREATH = 0.2
"""Simulated seconds of rest that are kept after each motion."""

_QUIET_HOLD, _LONGEST_HOLD = 1.2, 5.0
_SECONDS_A_SIGN = 0.025
"""How long a caption stands: so long, and longer by its length."""


@dataclass(frozen=True)
class FilmShot:
    """A picture of the film.

    Attributes:
        moment: Index into the footage's moments, or into a robot's pictures.
        call: Number of the call that the captions are about, from 0; None before the first.
        told: Whether the captions tell what came of it.
        speed: Of life's; None where time stands still.
        frames: How long it stands.
    """

    moment: int
    call: int | None
    told: bool
    speed: float | None
    frames: int = 1


Moving = tuple[int, float, int]
"""A moment in motion, its speed, and for how many frames it stands."""


def cut(footage: Footage, speed: float, texts: Sequence[tuple[int, int]]) -> list[FilmShot]:
    """All shots of a film, in order.

    Args:
        footage: What happened.
        speed: Of motions other than closing fingers, of life's.
        texts: Of each call, how many signs its captions have before and after it is done.
    """
    steady = _is_steady(footage.moments)
    gripping = _is_gripping(footage.moments, footage.task.setup.mount.parked)

    def motion(first: int, last: int) -> Iterator[Moving]:
        return _motion(first, last, steady, gripping, speed)

    return shots_of(footage.question, footage.calls, texts, motion)


def shots_of(
    question: Question,
    calls: Sequence[FilmedCall],
    texts: Sequence[tuple[int, int]],
    motion: Callable[[int, int], Iterable[Moving]],
) -> list[FilmShot]:
    """The question, then each call: its caption, what moved, what came of it.

    Args:
        question: What was asked.
        calls: In order.
        texts: As in cut().
        motion: What to show of what moved between two moments.
    """
    shots = [FilmShot(0, None, told=False, speed=None, frames=_hold(len(question.text)))]
    for number, (each, (before, after)) in enumerate(zip(calls, texts, strict=True)):
        shots.append(FilmShot(each.first, number, told=False, speed=None, frames=_hold(before)))
        for moment, rate, frames in motion(each.first, each.last):
            shots.append(FilmShot(moment, number, told=False, speed=rate, frames=frames))
        shots.append(FilmShot(each.last, number, told=True, speed=None, frames=_hold(after)))
    return shots


def moments_in_motion(footage: Footage) -> list[int]:
    """Indices of the moments after which something moves."""
    return np.flatnonzero(~_is_steady(footage.moments)).tolist()


def _hold(signs: int) -> int:
    """Frames that a caption of so many signs stands."""
    return round(FPS * min(_LONGEST_HOLD, _QUIET_HOLD + _SECONDS_A_SIGN * signs))


def _motion(
    first: int, last: int, steady: Array, gripping: Array, speed: float
) -> Iterator[Moving]:
    """Moments to show, one a frame."""
    place, rest = float(first), 0.0
    while round(place) < last:
        index = round(place)
        rest = rest + SAMPLE_TIME if steady[index] and not gripping[index] else 0.0
        if rest > _BREATH:
            place = index + 1.0
            continue
        rate = SLOW if gripping[index] else speed
        yield index, rate, 1
        place += rate / FPS / SAMPLE_TIME


def _is_steady(moments: Sequence[TableMoment]) -> Array:
    """Whether nothing moves until the next moment, shape (n,)."""
    joints = np.array([moment.joints for moment in moments])
    turned = np.abs(np.diff(joints, axis=0)).max(axis=1, initial=0.0)
    fingers = np.abs(np.diff([moment.opening for moment in moments]))
    places = np.array(
        [np.ravel([placed.pose.position for placed in moment.objects]) for moment in moments]
    )
    moved = np.abs(np.diff(places, axis=0)).max(axis=1, initial=0.0)
    rest = (turned < _STILL_RAD) & (fingers < _STILL_M) & (moved < _STILL_M)
    return np.append(rest, True)


def _is_gripping(moments: Sequence[TableMoment], parked: Sequence[float]) -> Array:
    """Whether the pads approach each other then or nearly then, shape (n,).

    Where the arm is parked they close on nothing: they only take the width that they will need.
    """
    change = np.diff([moment.opening for moment in moments])
    away = np.abs(np.array([moment.joints for moment in moments]) - parked).max(axis=1)
    closing = np.flatnonzero((change < -_CLOSING_M) & (away[1:] > _PARKED_RAD))
    apart = np.abs(np.arange(len(moments))[:, None] - closing).min(axis=1, initial=len(moments))
    return apart * SAMPLE_TIME <= _AROUND
