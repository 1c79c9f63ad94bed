"""Things told apart by colours and depth and called by an operator's names. Labels aren't read."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from probe.perception.enrolled.enrolment import Enrolment
from probe.perception.enrolled.nearness import odds
from probe.perception.enrolled.signature import signature_of
from probe.perception.naming import SEEN_PX
from probe.perception.segmenter import Segmenter
from probe.perception.things import Thing, Words
from probe.types import Array, Frame

NEAR = 0.0
"""Logarithm of the odds from which on what shows is called by an object's name."""

CLEAR = 0.5
"""By how much these odds have to be better than the next object's."""


class EnrolledDetector:
    """Calls each segment by the object that it looks most like, if that one is near and clear.

    Whatever can't be named so is described by the colours and the outline of its pixels.
    """

    def __init__(self, enrolment: Enrolment, segmenter: Segmenter) -> None:
        """Set up.

        Args:
            enrolment: The objects that are known.
            segmenter: Tells things apart.
        """
        self._enrolment = enrolment
        self._segmenter = segmenter
        self._last: tuple[Frame, tuple[Thing, ...]] | None = None

    def needs_rgb(self, frame: Frame) -> bool:
        """Always: things are told apart and recognised by their colours too."""
        return True

    def detect(self, frame: Frame) -> tuple[Thing, ...]:
        """Everything on the table, sorted by point from the top; see Segmenter.detect().

        Raises:
            MissingExtra: scikit-image isn't installed.
        """
        if self._last is None or self._last[0] is not frame:
            segments = self._segmenter.detect(frame)
            known = once([self._odds(thing.mask, frame) for thing in segments])
            self._last = frame, tuple(map(self._called, segments, known))
        return self._last[1]

    def _odds(self, mask: Array, frame: Frame) -> Array:
        """For each object the best odds of its views, shape (n,)."""
        if np.count_nonzero(mask) < SEEN_PX:
            return np.full(len(self._enrolment.objects), -np.inf)
        seen = signature_of(frame, mask)
        return np.array(
            [max(odds(seen, view) for view in known.views) for known in self._enrolment.objects]
        )

    def _called(self, thing: Thing, known: int | None) -> Thing:
        words = thing.words
        if known is None:
            description = f"something that was not recognised: {words.description}"
            return replace(thing, words=replace(words, description=description))
        said = self._enrolment.objects[known].words
        description = said.description or f"{said.name}: {words.description}"
        told = Words(said.name, "", words.colours, description, said.synonyms)
        return replace(thing, words=told)


def once(odds_of: Sequence[Array]) -> list[int | None]:
    """Which object each segment is, by its number; None if none is near and clear.

    Each object is on the table once: of several segments that come nearest to the same one, only
    the likeliest is it. The others may be parts of it, or something else.

    Args:
        odds_of: By segment, the odds of each object, shape (n,) with n > 0.
    """
    chosen = [int(each.argmax()) if _near_and_clear(each) else None for each in odds_of]
    best: dict[int, int] = {}
    for segment, known in enumerate(chosen):
        if known is None:
            continue
        rival = best.get(known)
        if rival is None or odds_of[segment][known] > odds_of[rival][known]:
            best[known] = segment
    return [
        known if known is not None and best[known] == segment else None
        for segment, known in enumerate(chosen)
    ]


def _near_and_clear(each: Array) -> bool:
    second, first = np.sort(np.append(each, -np.inf))[-2:]
    return bool(first >= NEAR and first - second >= CLEAR)
