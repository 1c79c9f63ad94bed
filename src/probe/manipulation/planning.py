"""Which grasp is tried next, with all that the choice was made from. Moves nothing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from probe.manipulation.candidates import Grasp, Planner
from probe.manipulation.handshape import HandShape
from probe.manipulation.removal import Removal, Route, plan_removal
from probe.manipulation.target import Target, target_of
from probe.manipulation.terrain import Terrain, survey
from probe.scene.setup import Setup
from probe.station.station import Station
from probe.types import Array, Frame

_ROUTES = 16
_SAME_PLACE = 0.012
_SAME_AXIS = np.cos(np.radians(25.0))


@dataclass(frozen=True, eq=False)
class PlannerTurn:
    """What one planner proposed, and how far that got.

    Attributes:
        planner: Who.
        spent: Grasps that aren't worth a try after those that failed.
        fresh: The others, best first.
        routes: Of the fresh ones whose paths were looked for, in the same order.
    """

    planner: Planner
    spent: tuple[Grasp, ...]
    fresh: tuple[Grasp, ...]
    routes: tuple[Route, ...]


@dataclass(frozen=True, eq=False)
class GraspPlan:
    """The choice of a grasp.

    Attributes:
        frame: The table as it was seen.
        terrain: The same as heights.
        target: What is to be grasped.
        start: Joint angles from which paths begin, radians, shape (n,).
        turns: Of the planners that were asked, in order.
        removal: What was chosen; None if no grasp has a free route.
    """

    frame: Frame
    terrain: Terrain
    target: Target
    start: Array
    turns: tuple[PlannerTurn, ...]
    removal: Removal | None

    @property
    def lack(self) -> Literal["no_candidate", "unreachable"]:
        """Why there is no grasp where there is none."""
        return "unreachable" if any(turn.fresh for turn in self.turns) else "no_candidate"

    @property
    def candidates(self) -> int:
        """How many grasps fitted."""
        return sum(len(turn.spent) + len(turn.fresh) for turn in self.turns)


def plan_grasp(
    station: Station,
    frame: Frame,
    mask: Array,
    setup: Setup,
    failed: Sequence[Grasp],
    planners: Sequence[Planner],
) -> GraspPlan:
    """Choose the best grasp, unlike those that failed, that has free paths.

    Args:
        station: The arm, and the camera over the basket.
        frame: The table as it is now.
        mask: Which pixels show the thing, bool, shape (h, w).
        setup: The table's.
        failed: Grasps of the same thing that were carried out in vain.
        planners: Each is asked where those before have no grasp with a free route.
    """
    shape = HandShape(station.hand)
    terrain = survey(frame, setup, station.look_into_basket(rgb=False))
    target = target_of(frame, mask, terrain)
    start, turns, removal = station.joints(), list[PlannerTurn](), None
    for planner in planners:
        grasps = planner(target, terrain, station.hand)
        fresh = tuple(g for g in grasps if not _spent(g, failed))
        spent = tuple(g for g in grasps if _spent(g, failed))
        routes, removal = plan_removal(
            station.arm, start, terrain, target, fresh[:_ROUTES], shape, setup.basket
        )
        turns.append(PlannerTurn(planner, spent, fresh, routes))
        if removal is not None:
            break
    return GraspPlan(frame, terrain, target, start, tuple(turns), removal)


def _spent(grasp: Grasp, failed: Sequence[Grasp]) -> bool:
    """Whether a grasp isn't worth a try after those that failed.

    One by an edge that fails shoves the thing over what lies beneath. A second one by an edge never
    got it: 0 of the 14 wide things, of 109 on fresh tables, that were tried again.
    """
    if grasp.by_edge and any(other.by_edge for other in failed):
        return True
    return any(_alike(grasp, other) for other in failed)


def _alike(one: Grasp, other: Grasp) -> bool:
    """Whether two grasps hold about the same place from about the same side."""
    apart = np.subtract(one.middle, other.middle)
    turned = abs(float(one.hand.rotation[:, 1] @ other.hand.rotation[:, 1]))
    return bool(np.linalg.norm(apart) < _SAME_PLACE and turned > _SAME_AXIS)
