"""The ideal detector: reads a simulated frame's labels, only of what counts as seen."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from probe.assets.colour.names import Colour
from probe.assets.spec import ObjectSpec
from probe.errors import ProbeError
from probe.perception.looks import belies, look_of
from probe.perception.naming import PLAIN_SHARE, SEEN_SHARE, identifies
from probe.perception.posture import Poses, Posture, described, posture
from probe.perception.things import Thing, Words
from probe.types import Array, Frame, Pose

NOTICED_PX = 125
"""Visible pixels from which on something is noticed at all: a square of 6 mm, usually."""


class NoLabels(ProbeError):
    """The ideal detector was given a frame without labels or shares, or without colours."""

    def __init__(self, missing: str) -> None:
        super().__init__(
            f"This frame carries no {missing}. The ideal detector works on a simulated station's "
            "frames alone; use a segmentation model for others."
        )


class Oracle:
    """Detects without error what counts as seen, and says nothing of the rest.

    A thing gets the catalogue's words if what shows of it identifies it (see `naming`). They are
    put right where it lies otherwise than they suppose (see `posture`) or shows none of the colours
    that they name. Of anything else that is noticed the colours and the outline are told.
    """

    def __init__(self, words: Mapping[int, ObjectSpec], poses: Poses | None = None) -> None:
        """Set up.

        Args:
            words: What the catalogue says of each object in the scene, by instance.
            poses: Where they are; None if postures are to go untold.
        """
        self._words = dict(words)
        self._poses = poses
        # The same patch is always told alike, so that its colours are drawn only once.
        self._belied: dict[str, tuple[Colour, ...]] = {}
        self._looks: dict[str, tuple[tuple[Colour, ...], str]] = {}

    def needs_rgb(self, frame: Frame) -> bool:
        """Whether something shows whose colours haven't been looked at."""
        labels = _labels(frame)
        known = self._belied.keys() | self._looks.keys()
        return any(_patch(labels == n, frame) not in known for n in _noticed(frame))

    def detect(self, frame: Frame) -> tuple[Thing, ...]:
        """Things that show, sorted by their point from top to bottom, then left to right.

        Raises:
            NoLabels: It isn't a simulated frame, or it lacks colours where needs_rgb says so.
        """
        shares, labels = _shares(frame), _labels(frame)
        poses: Mapping[int, Pose] = {} if self._poses is None else self._poses()
        things: list[Thing] = []
        for instance in _noticed(frame):
            mask: Array = labels == instance
            spec, share = self._words[instance], shares[instance]
            if identifies(mask, share, spec.size):
                how = posture(spec, poses[instance]) if poses else "as told"
                words = _named(spec, how, self._belies(spec, mask, frame))
            else:
                words = _unnamed(share, *self._look(mask, frame))
            things.append(Thing.of(mask, words))
        return tuple(sorted(things, key=lambda thing: thing.point_px[::-1]))

    def _belies(self, spec: ObjectSpec, mask: Array, frame: Frame) -> tuple[Colour, ...]:
        patch = _patch(mask, frame)
        if patch not in self._belied:
            self._belied[patch] = belies(_rgb(frame)[mask], spec.colours)
        return self._belied[patch]

    def _look(self, mask: Array, frame: Frame) -> tuple[tuple[Colour, ...], str]:
        patch = _patch(mask, frame)
        if patch not in self._looks:
            _rgb(frame)
            self._looks[patch] = look_of(mask, frame)
        return self._looks[patch]


def words_of(spec: ObjectSpec) -> Words:
    """What the catalogue says of an object."""
    return Words(spec.name, spec.category, spec.colours, spec.description)


def _named(spec: ObjectSpec, how: Posture, belied: tuple[Colour, ...]) -> Words:
    text = described(spec, how)
    if belied:
        text = f"{text.removesuffix('.')}; what shows of it is {' and '.join(belied)}."
    return replace(words_of(spec), colours=spec.colours + belied, description=text)


def _unnamed(share: float, colours: tuple[Colour, ...], phrase: str) -> Words:
    if share < SEEN_SHARE:
        what = "part of something that is mostly hidden"
    elif share < PLAIN_SHARE:
        what = "part of something that is half hidden"
    else:
        what = "something small"
    return Words(None, "", colours, f"{what}: {phrase}")


def _patch(mask: Array, frame: Frame) -> str:
    """A visible patch by its place and its depth."""
    content = hashlib.sha256(np.packbits(mask).tobytes())
    content.update(frame.depth[mask].tobytes())
    return content.hexdigest()


def _noticed(frame: Frame) -> list[int]:
    """Instances of all that can be noticed."""
    counts = np.bincount(_labels(frame).ravel())
    return [n for n in range(1, len(counts)) if counts[n] >= NOTICED_PX]


def _labels(frame: Frame) -> Array:
    if frame.labels is None:
        raise NoLabels("labels")
    return frame.labels


def _shares(frame: Frame) -> Mapping[int, float]:
    if frame.shares is None:
        raise NoLabels("visible shares")
    return frame.shares


def _rgb(frame: Frame) -> Array:
    if frame.rgb is None:
        raise NoLabels("colours")
    return frame.rgb
