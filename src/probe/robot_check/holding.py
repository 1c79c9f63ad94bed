"""Carries the known box before the cameras and collects what they see of it."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from probe.robot_check.box import KnownBox
from probe.robot_check.carrying import Carrier
from probe.robot_check.errors import Impossible
from probe.robot_check.places import MOST, places, yaw_of
from probe.robot_check.seeing import Depth, SeenBox, look, sighted
from probe.scene.cameras import View
from probe.scene.setup import Setup
from probe.station.station import Station
from probe.types import Array, Pose

if TYPE_CHECKING:
    from probe_bridge.client import RobotClient

_STILL = 0.4
"""Seconds in which what the hand holds comes to rest."""


@dataclass(frozen=True)
class Cell:
    """A robot with the known box on its table.

    Attributes:
        client: Connected to the robot's bridge.
        station: The same robot. Its table is empty but for the box, upright in the middle.
        setup: The table.
        views: Cameras that look.
        box: What stands there.
    """

    client: RobotClient
    station: Station
    setup: Setup
    views: Sequence[View]
    box: KnownBox


@dataclass(frozen=True, eq=False)
class Shown:
    """A place, as one camera saw it with and without the box in the hand."""

    held: Depth
    bare: Depth
    world_from_box: Pose


@dataclass(frozen=True, eq=False)
class _Held:
    """A place: joint angles that were asked for, where the box then was, and what was seen."""

    asked: Array
    world_from_box: Pose
    seen: dict[View, Depth]


def held_up(cell: Cell, most: int = MOST) -> dict[View, list[Shown]]:
    """Take the box, hold it up at several places, drop it into the basket, and go there without.

    The arm is the same in both pictures of a place, so what differs is the box.

    Args:
        cell: The robot.
        most: Places at most, for each camera.

    Raises:
        Impossible: The box could not be taken or was lost, or something held the arm.
        RobotLost: The bridge doesn't answer.
    """
    carrier = Carrier(cell.station, cell.setup, cell.box)
    tool_from_box = carrier.take()
    held = list(_visits(cell, carrier, tool_from_box, most))
    if not carrier.holds():
        text = "The hand lost the box on the way."
        raise Impossible("box lost", text, "Take a lighter one, or one that slips less.")
    carrier.drop()
    found: dict[View, list[Shown]] = {view: [] for view in cell.views}
    for place in held:
        if not carrier.again(place.asked):
            continue
        cell.station.wait(_STILL)
        for view, depth in place.seen.items():
            found[view].append(Shown(depth, look(cell.client, view), place.world_from_box))
    carrier.home()
    return found


def sightings(shown: Sequence[Shown]) -> list[SeenBox]:
    """The places of one camera at which the box can be made out."""
    found = [sighted(each.held, each.bare, each.world_from_box) for each in shown]
    return [each for each in found if each is not None]


def _visits(cell: Cell, carrier: Carrier, tool_from_box: Pose, most: int) -> Iterator[_Held]:
    """Hold the box at one place after another, as long as a camera needs more of them."""
    wanted: dict[View, list[Pose]] = {view: _places(cell, view) for view in cell.views}
    counts: dict[View, int] = dict.fromkeys(cell.views, 0)
    done: set[Pose] = set()
    for view in cell.views:
        for pose in wanted[view]:
            if counts[view] >= most or pose in done:
                continue
            goal = carrier.to(carrier.down(pose.matrix[:3, 3], yaw_of(pose)))
            if goal is None:
                continue
            done.add(pose)
            cell.station.wait(_STILL)
            showing: list[View] = [each for each in cell.views if pose in wanted[each]]
            seen: dict[View, Depth] = {each: look(cell.client, each) for each in showing}
            for each in showing:
                counts[each] += 1
            world_from_tool = cell.station.arm.forward(cell.station.joints())
            yield _Held(goal, world_from_tool @ tool_from_box, seen)


def _places(cell: Cell, view: View) -> list[Pose]:
    return places(cell.setup.camera(view), cell.box, cell.setup.work_area)
