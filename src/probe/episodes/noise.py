"""Noise of manipulations: the hand errs by an amount that depends on what is done, not on when.

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
from probe.errors import UnknownName
from probe.scene.seeds import generator
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

NOISES: dict[NoiseName, Noise] = {"none": Noise(), "paper": Noise(grasp=0.018)}
"""By name; "paper" is calibrated to the paper's 73.5 % of grasps (docs/results/tools.md)."""

NO_NOISE = NOISES["none"]


def noise_of(noise: Noise | NoiseName) -> Noise:
    """A noise, given as it is or by its name.

    Raises:
        UnknownName: There is none of this name.
    """
    if isinstance(noise, Noise):
        return noise
    if noise not in NOISES:
        raise UnknownName("noise", noise, list(NOISES))
    return NOISES[noise]


class HandErrors:
    """By how much the hand misses in each attempt of an episode.

    Args:
        noise: How far it errs.
        seed: Of the episode.
        run: Of the episode's runs.
    """

    def __init__(self, noise: Noise, seed: int, run: int) -> None:
        self._sigma = {"grasp": noise.grasp, "push": noise.push}
        self._key = (seed, run)
        self._attempts: Counter[tuple[str, int]] = Counter()

    def draw(self, tool: Literal["grasp", "push"], frame: Frame, mask: Array) -> Array | None:
        """The next attempt's error, metres, shape (3,), world axes; None for a hand without any.

        Args:
            tool: What is attempted.
            frame: The table as it is now, with labels.
            mask: Which pixels show the thing, bool, shape (h, w).
        """
        sigma = self._sigma[tool]
        if sigma == 0:
            return None
        instance = touched(frame, mask)
        self._attempts[tool, instance] += 1
        seed, run = self._key
        rng = generator(seed, "luck", run, tool, instance, self._attempts[tool, instance])
        return np.array([*(sigma * rng.standard_normal(2)), 0.0])
