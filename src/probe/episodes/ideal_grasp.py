"""A grasp that always works, to tell errors of the hand from errors of the plan.

It stands where skills stand: tools call it as they call any, and agents read the same words.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from probe.episodes.touched import touched
from probe.scene.setup import Setup
from probe.station.station import Station
from probe.toolshed.skills import Direction, PushOutcome, SkillOutcome, Skills
from probe.types import Array, Frame


class InstantRemoval(Protocol):
    """What a simulated table can do that no arm can."""

    def take_away(self, instance: int) -> None:
        """Put an object into the basket; what leaned on it comes to rest."""
        ...


@dataclass(frozen=True, eq=False)
class _Taken:
    """How an ideal grasp went."""

    status: str
    frame: Frame


class IdealGrasp:
    """Skills of which grasping never fails: the thing is in the basket, and physics does the rest.

    Args:
        skills: Do the pushing.
        magic: The table.
    """

    def __init__(self, skills: Skills, magic: InstantRemoval) -> None:
        self._skills = skills
        self._magic = magic

    def grasp_and_remove(
        self, station: Station, frame: Frame, mask: Array, setup: Setup, /
    ) -> SkillOutcome:
        """As Skills; a mask that shows mostly table gives nothing to take."""
        instance = touched(frame, mask)
        if instance == 0:
            return _Taken("no_candidate", frame)
        self._magic.take_away(instance)
        return _Taken("removed", station.observe(rgb=False))

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
        return self._skills.push(station, frame, mask, direction, distance, setup)
