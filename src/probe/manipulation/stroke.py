"""One sweep of the closed gripper along a direction, planned on one look. Judges nothing."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from probe.manipulation.handshape import HandShape
from probe.manipulation.kinematics import either_way, line, moved, reaching, straight
from probe.manipulation.looking import still_there
from probe.manipulation.obstacles import Obstacles
from probe.manipulation.parking import park
from probe.manipulation.pushing import DESCENT, PlannedPush
from probe.manipulation.room import room_ahead
from probe.manipulation.routes import over
from probe.manipulation.starts import close, starts
from probe.manipulation.sweeping import pressed, swept
from probe.manipulation.target import target_of
from probe.manipulation.terrain import survey
from probe.scene.setup import Setup
from probe.station.station import Station
from probe.types import Array, Frame, Pose

StrokeEnd = Literal["swept", "no_space", "unreachable", "blocked"]
"""How a stroke ended: the tool went its whole way; there is nowhere to begin; the arm can't follow
any such path; something stopped the arm."""

_PARTS = (1.0, 0.75, 0.5, 0.25)
_LEAST = 0.008
_STAYED = 0.9
_SPARE = 0.005
_STARTS = 3


@dataclass(frozen=True, eq=False)
class Stroke:
    """What came of one.

    Attributes:
        end: See StrokeEnd.
        frame: The table afterwards, without colours.
        swept: How far the tool went from where it should have touched, metres; less than asked
            for where the basket or the arm's reach ended it.
        starts: world_from_hand where it began; none if it didn't.
        room: How far the thing could go before it would meet the basket, metres.
    """

    end: StrokeEnd
    frame: Frame
    swept: float = 0.0
    starts: tuple[Pose, ...] = ()
    room: float = math.inf


@dataclass(frozen=True, eq=False)
class _Route:
    push: PlannedPush
    transit: Array
    descent: Array
    sweep: Array
    travel: float


def stroke(
    station: Station,
    frame: Frame,
    mask: Array,
    along: Array,
    distance: float,
    setup: Setup,
    unlike: Sequence[Pose] = (),
    *,
    clear: bool = False,
) -> Stroke:
    """Sweep once behind what a mask shows; the arm starts and ends parked.

    Args:
        station: The arm, camera and table.
        frame: The table as it is now.
        mask: Which pixels show the thing, bool, shape (h, w).
        along: Unit direction, level, shape (3,).
        distance: How far to push it, metres.
        setup: The table's.
        unlike: Starts that need not be tried again.
        clear: Whether the hand may meet nothing else on its way.
    """
    terrain = survey(frame, setup)
    target = target_of(frame, mask, terrain)
    shape, obstacles = HandShape(station.hand), Obstacles.of(station.arm, terrain)
    room = room_ahead(target, terrain, along, setup.basket)
    distance = min(distance, room)
    options = starts(target, terrain, shape, along, distance, unlike, clear=clear)
    result = Stroke("unreachable" if options else "no_space", frame, room=room)
    if distance < _LEAST:
        return result
    for _ in range(_STARTS):
        best = _best(station, obstacles, options, along * distance, shape)
        if best is None:
            break
        result = replace(_execute(station, obstacles, best, shape, along), room=room)
        stayed = still_there(frame, result.frame, mask)
        if result.end == "swept" or result.swept > 0 or stayed < _STAYED:
            break
        # Stopped before it met the thing, which is still where it was: from elsewhere, then.
        options = [option for option in options if not close(option, best.push.start)]
    return result


def _best(
    station: Station,
    obstacles: Obstacles,
    options: Sequence[PlannedPush],
    way: Array,
    shape: HandShape,
) -> _Route | None:
    """The first option that the arm can follow all the way, or else most of it."""
    distance = float(np.linalg.norm(way))
    for part in _PARTS:
        for option in options:
            travel = way * (option.gap / distance + part)
            route = _route(station, obstacles, option, travel, shape)
            if route is not None:
                return route
    return None


def _route(
    station: Station, obstacles: Obstacles, option: PlannedPush, travel: Array, shape: HandShape
) -> _Route | None:
    """A free path to the start of a push and along it; None if the arm has none."""
    arm, parked = station.arm, station.joints()
    for start in either_way(option.start):
        end = reaching(arm, moved(start, travel), parked)
        if not end:
            continue
        for joints in reaching(arm, start, parked)[:2]:
            sweep = straight(arm, joints, line(start, travel))
            rise = straight(arm, joints, line(start, (0.0, 0.0, DESCENT)))
            if sweep is None or rise is None or not obstacles.arm_free(joints):
                continue
            transit = over(arm, parked, rise[-1], obstacles, shape.whole(0.0)[::3])
            if transit is not None:
                descent = np.vstack([rise[-2::-1], joints])
                return _Route(option, transit, descent, sweep, float(np.linalg.norm(travel)))
    return None


def _execute(
    station: Station, obstacles: Obstacles, route: _Route, shape: HandShape, along: Array
) -> Stroke:
    """Push, lift, park and look."""
    gone = 0.0
    station.grip(0.0)
    if station.follow(route.transit) and station.follow(route.descent):
        gone = _swept(station, route, along * route.travel)
    came = np.vstack([route.transit, route.descent, route.sweep])
    park(station, obstacles, shape.whole(0.0)[::3], came)
    station.grip(station.hand.max_opening)
    end: StrokeEnd = "swept" if gone > route.travel - _SPARE else "blocked"
    frame = station.observe(rgb=False)
    return Stroke(end, frame, max(0.0, gone - route.push.gap), (route.push.start,))


def _swept(station: Station, route: _Route, way: Array) -> float:
    """Metres that the hand came along a way."""
    joints, path = route.descent[-1], route.sweep
    if route.push.pressed:
        joints = pressed(station, joints)
        path = straight(station.arm, joints, line(station.arm.forward(joints), way))
    return 0.0 if path is None else swept(station, np.vstack([joints, path]), way)
