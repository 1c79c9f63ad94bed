"""Choosing the first grasp with a free route, and carrying it out. Looks at nothing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np

from probe.manipulation.candidates import Grasp
from probe.manipulation.handshape import HandShape
from probe.manipulation.obstacles import Obstacles
from probe.manipulation.parking import park
from probe.manipulation.routes import WayIn, WayOut, way_in, way_out
from probe.manipulation.target import Target
from probe.manipulation.terrain import Terrain
from probe.scene.setup import Basket
from probe.station.station import Arm, Station
from probe.types import Array

EMPTY = 0.0015
"""Metres between the pads under which they hold nothing."""

_RELEASE = 0.03


@dataclass(frozen=True, eq=False)
class Route:
    """How far the search for a grasp's paths got.

    Attributes:
        grasp: How to hold it.
        enter: From the parked place around it; None if no such path is free.
        leave: Up and over the basket; None if there is none, or no way in.
    """

    grasp: Grasp
    enter: WayIn | None
    leave: WayOut | None


@dataclass(frozen=True, eq=False)
class Removal:
    """A grasp with its paths.

    Attributes:
        grasp: How to hold it.
        enter: From the parked place around it.
        leave: Up and over the basket.
        obstacles: All that stands on the table but the target.
    """

    grasp: Grasp
    enter: WayIn
    leave: WayOut
    obstacles: Obstacles

    @property
    def way(self) -> Array:
        """All of it until the target is let go, from the parked place on, shape (m, n)."""
        enter, leave = self.enter, self.leave
        return np.vstack([enter.transit, enter.approach, leave.lift, leave.carry, leave.lower])


def plan_removal(
    arm: Arm,
    start: Array,
    terrain: Terrain,
    target: Target,
    grasps: Sequence[Grasp],
    shape: HandShape,
    basket: Basket,
) -> tuple[tuple[Route, ...], Removal | None]:
    """Paths for the first grasp that has any, and how far each one before it got.

    Args:
        arm: The arm.
        start: Joint angles from which it begins, radians, shape (n,).
        terrain: All that is seen.
        target: What is to be removed.
        grasps: Best first.
        shape: The gripper's.
        basket: Where the target goes.

    Returns:
        The routes of all that were tried, and the removal; None if no grasp has a free route.
    """
    if not grasps:
        return (), None
    full = Obstacles.of(arm, terrain)
    bare = Obstacles.of(arm, terrain.without(target.cells))
    tried: list[Route] = []
    for grasp in grasps:
        enter, leave = way_in(arm, start, full, grasp, shape), None
        if enter is not None:
            points = shape.whole(grasp.opening)
            leave = way_out(bare, enter.approach[-1], grasp, target, basket, points)
        tried.append(Route(grasp, enter, leave))
        if enter is not None and leave is not None:
            return tuple(tried), Removal(grasp, enter, leave, bare)
    return tuple(tried), None


def remove(
    station: Station, removal: Removal, shape: HandShape
) -> Literal["removed", "blocked", "slipped", "dropped"]:
    """Close, lift, carry and let go; the arm is parked again whatever happens.

    Raises:
        ArmStuck: It can't be.
    """
    status = _carry_out(station, removal)
    # Fingers opened wider than on the way in may meet the forearm on the way home.
    station.grip(removal.grasp.opening)
    points = shape.whole(removal.grasp.opening)[::3]
    park(station, removal.obstacles, points, removal.way)
    return status


def _carry_out(
    station: Station, removal: Removal
) -> Literal["removed", "blocked", "slipped", "dropped"]:
    failure = _taken(station, removal)
    if failure is not None:
        return failure
    leave = removal.leave
    arrived = station.follow(leave.carry)
    if station.grip(0.0) < EMPTY:
        return "dropped"
    if not arrived:
        return "blocked"
    if len(leave.lower):
        station.follow(leave.lower)
    station.grip(min(removal.grasp.width + _RELEASE, station.hand.max_opening))
    return "removed"


def _taken(station: Station, removal: Removal) -> Literal["blocked", "slipped"] | None:
    """Close and lift; what stopped it, or None."""
    enter, leave = removal.enter, removal.leave
    station.grip(removal.grasp.opening)
    if not station.follow(enter.transit):
        return "blocked"
    if not station.follow(enter.approach):
        return _withdrawn(station, removal, "blocked")
    if station.grip(0.0) < EMPTY:
        return _withdrawn(station, removal, "slipped")
    if not station.follow(leave.lift):
        return "blocked"
    return "slipped" if station.grip(0.0) < EMPTY else None


def _withdrawn(
    station: Station, removal: Removal, status: Literal["blocked", "slipped"]
) -> Literal["blocked", "slipped"]:
    """Back to where the approach began; a finger below something must not open or rise there."""
    station.grip(removal.grasp.opening)
    station.follow(removal.enter.transit[-1:])
    return status
