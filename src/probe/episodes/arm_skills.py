"""The arm's skills in an episode: with noise, other planners, or grasps that always work."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

from probe.episodes.noise import NO_NOISE, HandErrors, Noise
from probe.episodes.touched import touched
from probe.manipulation.candidates import Planner
from probe.manipulation.grasp import PLANNERS, GraspResult, grasp_and_remove
from probe.manipulation.push import PushResult, push
from probe.scene.setup import Setup
from probe.station.offset_station import OffsetStation
from probe.station.station import Station
from probe.toolshed.skills import Direction
from probe.types import Array, Frame


class InstantRemoval(Protocol):
    """What a simulated table can do that no arm can."""

    def take_away(self, instance: int) -> None:
        """Put an object into the basket; what leaned on it comes to rest."""
        ...


class ArmSkills:
    """Grasping and pushing by an arm whose hand may err.

    Args:
        noise: How far the hand errs; any noise needs frames with labels.
        seed: Of the episode, for the noise.
        run: Of the episode's runs, for the noise.
        planners: Propose the grasps; see probe.manipulation.grasp.
        removal: A simulated table that takes away what is to be grasped, so that grasping never
            fails and physics does the rest: this tells errors of the hand from errors of the plan.
            None for real grasps.
    """

    def __init__(
        self,
        noise: Noise = NO_NOISE,
        seed: int = 0,
        run: int = 0,
        planners: Sequence[Planner] = PLANNERS,
        removal: InstantRemoval | None = None,
    ) -> None:
        self._errors = HandErrors(noise, seed, run)
        self._planners = planners
        self._removal = removal

    def grasp_and_remove(
        self, station: Station, frame: Frame, mask: Array, setup: Setup, /
    ) -> GraspResult:
        """See probe.manipulation.grasp."""
        if self._removal is not None:
            return _take_away(self._removal, station, frame, mask)
        erring = _missing_by(self._errors.draw("grasp", frame, mask), station)
        return grasp_and_remove(erring, frame, mask, setup, self._planners)

    def push(
        self,
        station: Station,
        frame: Frame,
        mask: Array,
        direction: Direction,
        distance: float,
        setup: Setup,
        /,
    ) -> PushResult:
        """See probe.manipulation.push."""
        erring = _missing_by(self._errors.draw("push", frame, mask), station)
        return push(erring, frame, mask, direction, distance, setup)


def _missing_by(error: Array | None, station: Station) -> Station:
    """The station as a hand with this error sees it."""
    return station if error is None else OffsetStation(station, error)


def _take_away(removal: InstantRemoval, station: Station, frame: Frame, mask: Array) -> GraspResult:
    """Take away what most of a mask shows; the bare table gives nothing to take."""
    instance = touched(frame, mask)
    if instance == 0:
        return GraspResult("no_candidate", frame, 0, 0, 0.0, 0.0, 0.0)
    removal.take_away(instance)
    return GraspResult("removed", station.observe(rgb=False), 0, 0, 0.0, 0.0, 0.0)
