"""The skills with a planner of one's choice for the grasps."""

from __future__ import annotations

from dataclasses import dataclass

from probe.manipulation.candidates import Planner
from probe.manipulation.grasp import GraspResult, grasp_and_remove
from probe.manipulation.push import push
from probe.scene.setup import Setup
from probe.station.station import Station
from probe.types import Array, Frame


@dataclass(frozen=True)
class Planned:
    """Grasping and pushing, like this package itself, but grasps come from another planner.

    Attributes:
        planner: Such as a `GraspGen`.
    """

    planner: Planner

    def grasp_and_remove(
        self, station: Station, frame: Frame, mask: Array, setup: Setup, /
    ) -> GraspResult:
        """See probe.manipulation.grasp."""
        return grasp_and_remove(station, frame, mask, setup, self.planner)

    push = staticmethod(push)
