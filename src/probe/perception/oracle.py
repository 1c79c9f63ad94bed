"""The ideal detector: reads a simulated frame's labels, only of what counts as seen."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping

import numpy as np

from probe.assets.spec import ObjectSpec
from probe.errors import ProbeError
from probe.perception.looks import look_of
from probe.perception.things import Thing, Words
from probe.types import Array, Frame

SEEN_SHARE = 0.30
"""Visible share from which on a thing can be named."""

SEEN_PX = 400
"""Visible pixels from which on a thing can be named."""

NOTICED_PX = 200
"""Visible pixels from which on something is noticed at all."""


class NoLabels(ProbeError):
    """The ideal detector was given a frame without labels or shares, or without colours."""

    def __init__(self, missing: str) -> None:
        super().__init__(
            f"This frame carries no {missing}. The ideal detector works on a simulated station's "
            "frames alone; use a segmentation model for others."
        )


class Oracle:
    """Detects without error what counts as seen, and says nothing of the rest.

    A thing of which 30 % and 400 px show gets the catalogue's words; one of which at least
    200 px show is told by the colours and the outline of these pixels; all else goes unnoticed.
    """

    def __init__(self, words: Mapping[int, ObjectSpec]) -> None:
        """Words: what the catalogue says of each object in the scene, by instance."""
        self._words = dict(words)
        self._told: dict[str, Words] = {}

    def needs_rgb(self, frame: Frame) -> bool:
        """Whether something shows that only its colours can tell of, and that is new."""
        shares, labels = _shares(frame), _labels(frame)
        return any(
            not _is_seen(shares[instance], count)
            and _patch(labels == instance, frame) not in self._told
            for instance, count in _noticed(frame).items()
        )

    def detect(self, frame: Frame) -> tuple[Thing, ...]:
        """Things that show, sorted by their point from top to bottom, then left to right.

        Raises:
            NoLabels: It isn't a simulated frame, or it lacks colours where needs_rgb says so.
        """
        shares, labels = _shares(frame), _labels(frame)
        things: list[Thing] = []
        for instance, count in _noticed(frame).items():
            mask: Array = labels == instance
            seen = _is_seen(shares[instance], count)
            words = words_of(self._words[instance]) if seen else self._coarse(mask, frame)
            things.append(Thing.of(mask, words))
        return tuple(sorted(things, key=lambda thing: thing.point_px[::-1]))

    def _coarse(self, mask: Array, frame: Frame) -> Words:
        """The same patch is always told alike, so that its colours are drawn only once."""
        patch = _patch(mask, frame)
        if patch not in self._told:
            if frame.rgb is None:
                raise NoLabels("colours")
            self._told[patch] = _look(mask, frame)
        return self._told[patch]


def words_of(spec: ObjectSpec) -> Words:
    """What the catalogue says of an object."""
    return Words(spec.name, spec.category, spec.colours, spec.description)


def _patch(mask: Array, frame: Frame) -> str:
    """A visible patch by its place and its depth."""
    content = hashlib.sha256(np.packbits(mask).tobytes())
    content.update(frame.depth[mask].tobytes())
    return content.hexdigest()


def _look(mask: Array, frame: Frame) -> Words:
    colours, look = look_of(mask, frame)
    return Words(None, "", colours, f"something mostly hidden: {look}")


def _is_seen(share: float, pixels: int) -> bool:
    return share >= SEEN_SHARE and pixels >= SEEN_PX


def _noticed(frame: Frame) -> dict[int, int]:
    """Visible pixels by instance, of all that can be noticed."""
    counts = np.bincount(_labels(frame).ravel())
    return {n: int(counts[n]) for n in range(1, len(counts)) if counts[n] >= NOTICED_PX}


def _labels(frame: Frame) -> Array:
    if frame.labels is None:
        raise NoLabels("labels")
    return frame.labels


def _shares(frame: Frame) -> Mapping[int, float]:
    if frame.shares is None:
        raise NoLabels("visible shares")
    return frame.shares
