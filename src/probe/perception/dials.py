"""Errors of a detector at chosen rates, the same whenever and however one asks.

Luck is a hash of the episode's seed, the run, the object, its pose and its visible mask: never of
the turn or of anybody's words. Poses and masks count roughly, so that a creep of a few tenths of a
millimetre doesn't change the draw.
"""

from __future__ import annotations

import hashlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Annotated

import numpy as np
from annotated_types import Interval
from pydantic import Field

from probe.errors import BadData
from probe.perception.general import kind_of
from probe.perception.mistakes import cut_in_two, invented, neighbour_of, united
from probe.perception.oracle import NoLabels
from probe.perception.posture import Poses
from probe.perception.things import Detector, Thing, Words
from probe.types import Array, Frame, Pose

Chance = Callable[[str], float]
"""An object's luck in its present state, for each kind of error: uniform in [0, 1)."""

_POSITION = 0.005
_TURN = 0.05
_MASK_PX = 32


ErrorRate = Annotated[float, Interval(ge=0, le=1)]
"""A share of detected objects; what reads one from a file checks its bounds."""


@dataclass(frozen=True)
class Dials:
    """Rates of errors, each 0 to 1, by detected object.

    Attributes:
        over: It is split in two.
        under: It is merged with the neighbour with which it shares the longest outline.
        missed: It is not detected.
        hallucinated: Something that isn't there is detected on bare table as well.
        general: Texts call it by its kind alone ("a fruit"), as far as it can be named. What one
            asks for by name is found as before: whoever points looks at the picture.
    """

    over: ErrorRate = 0.0
    under: ErrorRate = 0.0
    missed: ErrorRate = 0.0
    hallucinated: ErrorRate = 0.0
    general: Annotated[ErrorRate, Field(exclude_if=lambda rate: rate == 0)] = 0.0

    def __post_init__(self) -> None:
        for name, rate in vars(self).items():
            if not 0.0 <= rate <= 1.0:
                reason = f"{rate} is no rate"
                raise BadData(f"--dials.{name}", reason, "Say a number from 0 to 1")


class NoisyDetector:
    """A Detector of a simulated frame with errors put in; none with all dials at 0."""

    def __init__(
        self,
        detector: Detector,
        dials: Dials,
        poses: Poses,
        seed: int,
        run: int = 0,
        rumours: Sequence[Words] = (),
    ) -> None:
        """Set up.

        Args:
            detector: What it would be without errors.
            dials: Rates of errors.
            poses: Where things are.
            seed: Of the episode.
            run: Number of the run.
            rumours: What invented things are called: of objects that aren't in the scene, lest
                a name gives away a hidden one. Without any they have no name.
        """
        self._detector = detector
        self._dials = dials
        self._poses = poses
        self._key = f"{seed}/{run}"
        self._rumours = tuple(rumours) or (Words(None, "", (), "something on the table"),)

    def needs_rgb(self, frame: Frame) -> bool:
        """As the detector says that is put wrong."""
        return self._detector.needs_rgb(frame)

    def detect(self, frame: Frame) -> tuple[Thing, ...]:
        """Things that seem to show, sorted by their point from the top.

        Raises:
            NoLabels: It isn't a simulated frame.
        """
        things = self._detector.detect(frame)
        if self._dials == Dials():
            return things
        lucks = self._lucks(things, frame)
        noticed = [
            (self._told(thing, chance), chance)
            for thing, chance in zip(things, lucks, strict=True)
            if chance("missed") >= self._dials.missed
        ]
        found = [part for parts in self._parted(noticed) for part in parts]
        found += self._invented(things, lucks, frame)
        return tuple(sorted(found, key=lambda thing: thing.point_px[::-1]))

    def _lucks(self, things: Sequence[Thing], frame: Frame) -> list[Chance]:
        if frame.labels is None:
            raise NoLabels("labels")
        poses = self._poses()
        lucks: list[Chance] = []
        for thing in things:
            u, v = thing.point_px
            instance = int(frame.labels[v, u])
            state = f"{self._key}/{instance}/{_roughly(poses[instance])}/{_coarse(thing.mask)}"
            lucks.append(lambda kind, state=state: luck(f"{state}/{kind}"))
        return lucks

    def _told(self, thing: Thing, chance: Chance) -> Thing:
        if chance("general") >= self._dials.general:
            return thing
        return replace(thing, words=replace(thing.words, kind=kind_of(thing.words.category)))

    def _parted(self, noticed: Sequence[tuple[Thing, Chance]]) -> list[tuple[Thing, ...]]:
        """Each thing whole, in two, or gone into its neighbour."""
        left: dict[int, tuple[Thing, ...]]
        left = {index: (thing,) for index, (thing, _) in enumerate(noticed)}
        for index, (thing, chance) in enumerate(noticed):
            if chance("over") < self._dials.over:
                left[index] = cut_in_two(thing, np.pi * chance("angle"))
        for index, (_, chance) in enumerate(noticed):
            if chance("under") >= self._dials.under or len(left.get(index, ())) != 1:
                continue
            beside = [other for other in left if other != index and len(left[other]) == 1]
            choice = neighbour_of(left[index][0], [left[other][0] for other in beside])
            if choice is not None:
                left[beside[choice]] = (united(left.pop(index)[0], left[beside[choice]][0]),)
        return list(left.values())

    def _invented(
        self, things: Sequence[Thing], lucks: Sequence[Chance], frame: Frame
    ) -> list[Thing]:
        taken: Array = np.zeros(frame.depth.shape, bool)
        for thing in things:
            taken |= thing.mask
        found: list[Thing] = []
        for chance in lucks:
            if chance("hallucinated") < self._dials.hallucinated:
                # Not by its place in the list, which is another where there are other objects.
                words = min(self._rumours, key=lambda it: chance(f"words/{it.name}"))
                rng = np.random.default_rng(int(chance("place") * 2**53))
                thing = invented(taken, words, rng)
                if thing is not None:
                    taken |= thing.mask
                    found.append(self._told(thing, chance))
        return found


def luck(state: str) -> float:
    """A number in [0, 1) that depends on the text alone, on every machine alike."""
    return int.from_bytes(hashlib.sha256(state.encode()).digest()[:7]) / 2**56


def _roughly(pose: Pose) -> str:
    sign = -1 if pose.wxyz[0] < 0 else 1
    turn = [round(sign * part / _TURN) for part in pose.wxyz]
    return f"{[round(x / _POSITION) for x in pose.position]}{turn}"


def _coarse(mask: Array) -> str:
    """Which squares of the picture are mostly covered."""
    h, w = (size // _MASK_PX * _MASK_PX for size in mask.shape)
    squares = mask[:h, :w].reshape(h // _MASK_PX, _MASK_PX, w // _MASK_PX, _MASK_PX)
    covered: Array = squares.mean(axis=(1, 3)) > 0.5
    return hashlib.sha256(np.packbits(covered).tobytes()).hexdigest()
