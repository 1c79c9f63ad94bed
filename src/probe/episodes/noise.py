"""Luck of manipulations: the hand errs by an amount that depends on what is done, not on when.

Two agents that act alike in the same run of an episode fare alike; how they word it, which handle
they use and what else they moved before plays no part. Each new attempt on the same object
draws again, and so does each run.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass
from typing import Literal

import numpy as np

from probe.episodes.touched import touched
from probe.scene.seeds import generator
from probe.scene.setup import Setup
from probe.station.offset_station import OffsetStation
from probe.station.station import Station
from probe.toolshed.skills import Direction, PushOutcome, SkillOutcome, Skills
from probe.types import Array, Frame


@dataclass(frozen=True)
class Noise:
    """How far the hand errs.

    Attributes:
        grasp: Standard deviation along x and along y in a grasp, metres.
        push: The same in a push.
    """

    grasp: float = 0.0
    push: float = 0.0


NoiseName = Literal["none", "paper"]

NOISES: dict[NoiseName, Noise] = {"none": Noise(), "paper": Noise(grasp=0.0135)}
"""By name; "paper" is calibrated to the paper's 73.5 % of grasps (docs/results/tools.md)."""

NO_NOISE = NOISES["none"]


def noise_of(noise: Noise | NoiseName) -> Noise:
    """A noise, given as it is or by its name."""
    return NOISES[noise] if isinstance(noise, str) else noise


class NoisySkills:
    """Skills, carried out by a hand that errs.

    Args:
        skills: What is carried out.
        noise: By how much it errs.
        seed: Of the episode.
        run: Of the episode's runs.
    """

    def __init__(self, skills: Skills, noise: Noise, seed: int, run: int) -> None:
        self._skills = skills
        self._noise = noise
        self._key = (seed, run)
        self._attempts: Counter[tuple[str, int]] = Counter()

    def grasp_and_remove(
        self, station: Station, frame: Frame, mask: Array, setup: Setup, /
    ) -> SkillOutcome:
        """As Skills."""
        erring = self._erring(station, "grasp", self._noise.grasp, frame, mask)
        return self._skills.grasp_and_remove(erring, frame, mask, setup)

    def push(
        self,
        station: Station,
        frame: Frame,
        mask: Array,
        direction: Direction,
        distance: float,
        setup: Setup,
        /,
    ) -> PushOutcome:
        """As Skills."""
        erring = self._erring(station, "push", self._noise.push, frame, mask)
        return self._skills.push(erring, frame, mask, direction, distance, setup)

    def _erring(
        self, station: Station, tool: str, sigma: float, frame: Frame, mask: Array
    ) -> Station:
        if sigma == 0:
            return station
        instance = touched(frame, mask)
        self._attempts[tool, instance] += 1
        seed, run = self._key
        rng = generator(seed, "luck", run, tool, instance, self._attempts[tool, instance])
        return OffsetStation(station, np.array([*(sigma * rng.standard_normal(2)), 0.0]))
