"""The arm takes the known box and carries it from place to place. Looks at nothing."""

from __future__ import annotations

import math
from itertools import chain

import numpy as np

from probe.manipulation.handshape import HandShape
from probe.manipulation.kinematics import either_way, line, moved, reaching, straight
from probe.manipulation.obstacles import Obstacles
from probe.manipulation.routes import over
from probe.manipulation.terrain import CELL, Terrain, stamp_basket
from probe.robot_check.box import KnownBox
from probe.robot_check.errors import Impossible
from probe.scene.setup import Setup
from probe.station.station import Station
from probe.types import Array, Pose

_REACH = 1.2
"""Metres on each side of the table's middle that are known to be empty, but for box and basket."""

_SPARE = 0.01
"""By how much the box's sides and places are taken to be further out, metres."""

_BRANCHES = 4
_THINNED = 3
_ABOVE = 0.08
_FELT = 0.012
"""Metres by which the opening on the box may differ from its width."""

_LET_GO = 0.03


class Carrier:
    """Moves the hand, with or without the box.

    Args:
        station: The arm. Nothing stands on its table but the box, upright in the middle.
        setup: The table.
        box: What it carries.
    """

    def __init__(self, station: Station, setup: Setup, box: KnownBox) -> None:
        self._station = station
        self._setup = setup
        self._box = box
        self._shape = HandShape(station.hand)
        self._empty = Obstacles.of(station.arm, table_without(setup))
        self._held: Array | None = None

    @property
    def width(self) -> float:
        """How wide the hand is open on the box, metres."""
        return self._box.size[1]

    def down(self, middle: Array, yaw: float) -> Pose:
        """world_from_tool of a hand from above that holds a box whose middle is at a place.

        Args:
            middle: Of the box, world, metres, shape (3,).
            yaw: Of the box about the vertical, radians. The fingers close along its y.
        """
        return from_above(np.asarray(middle) + [0.0, 0.0, self._over()], yaw)

    def take(self) -> Pose:
        """Square the box up between the fingers from two sides, take it and lift it.

        Returns:
            tool_from_box.

        Raises:
            Impossible: The hand can't get there, or holds nothing then.
        """
        standing = Obstacles.of(self._station.arm, _table_with(self._setup, self._box))
        middle = np.array([0.0, 0.0, self._box.half[2]])
        self._station.grip(self._station.hand.max_opening)
        sides = (0.0, math.pi / 2)
        for number, yaw in enumerate(sides):
            # The fingers close along y of the hand, so across x of the box in the first grasp.
            pose = self.down(middle, yaw + math.pi / 2)
            self._go(moved(pose, (0.0, 0.0, _ABOVE)), standing, self._points(None))
            self._along(self._hand(), (0.0, 0.0, pose.position[2] - self._hand().position[2]))
            self._close(self._box.size[number])
            if number == 0:
                self._station.grip(self._station.hand.max_opening)
                self._along(self._hand(), (0.0, 0.0, _ABOVE))
        at = self._hand()
        stands = np.array([*at.position[:2], self._box.half[2]])
        tool_from_box = at.inverse() @ Pose.of(stands, _about_z(sides[1] + math.pi / 2))
        self._along(at, (0.0, 0.0, _ABOVE))
        self._held = tool_from_box.apply(self._box.surface(0.02))
        return tool_from_box

    def to(self, pose: Pose) -> Array | None:
        """Carry the hand to a pose; the joint angles that were asked for, None without a way."""
        return self._to(pose, self._empty, self._points(self._held))

    def again(self, joints: Array) -> bool:
        """Go to joint angles that `to` gave; whether the arm arrived."""
        return self._reach(joints, self._empty, self._points(self._held))

    def holds(self) -> bool:
        """Whether the hand still holds the box."""
        return abs(self._station.grip(0.0) - self.width) < _FELT

    def drop(self) -> None:
        """Let the box fall into the basket and go home; the hand then is as wide as it was.

        Raises:
            Impossible: No way leads over the basket; the hand still holds the box.
        """
        x, y, floor = self._setup.basket.position
        high = floor + self._setup.basket.size[2] + self._box.size[2] + 0.06
        for turn in np.radians([0, 45, 90, 135, 180]):
            if self.to(self.down(np.array([x, y, high]), float(turn))) is not None:
                break
        else:
            text = "No free way leads the box over the basket, so the hand still holds it."
            raise Impossible("out of reach", text, "Compare the set-up's basket with the real one.")
        self._station.grip(min(self.width + _LET_GO, self._station.hand.max_opening))
        self._held = None
        self._station.wait(0.5)
        self.home()
        self._station.grip(self.width)

    def home(self) -> None:
        """Bring the arm to its parked place."""
        parked, points = self._station.arm.parked, self._points(self._held)
        way = over(self._station.arm, parked, self._station.joints(), self._empty, points)
        path = parked[None] if way is None else np.vstack([way[-2::-1], parked])
        if not self._station.follow(path):
            text = "Something held the arm back on its way home."
            raise Impossible("blocked", text, "Look what it was, and free the arm.")

    def _over(self) -> float:
        """How far the tool's origin is above the box's middle: the pads end below its top."""
        hand = self._station.hand
        return hand.pad_reach(self.width) + self._box.half[2] - hand.pad_half[2]

    def _hand(self) -> Pose:
        return self._station.arm.forward(self._station.joints())

    def _points(self, held: Array | None) -> Array:
        hand = self._shape.whole(self._station.hand.max_opening)[::_THINNED]
        return hand if held is None else np.concatenate([hand, held])

    def _go(self, pose: Pose, obstacles: Obstacles, points: Array) -> None:
        if self._to(pose, obstacles, points) is None:
            at = ", ".join(f"{v:.2f}" for v in pose.position)
            text = f"No free way leads the hand to ({at})."
            raise Impossible("out of reach", text, "Compare the set-up's arm, base and areas.")

    def _to(self, pose: Pose, obstacles: Obstacles, points: Array) -> Array | None:
        start = self._station.joints()
        both = [reaching(self._station.arm, each, start) for each in either_way(pose)]
        goals = sorted(chain(*both), key=lambda goal: float(np.abs(goal - start).max()))
        tried = (goal for goal in goals[:_BRANCHES] if self._reach(goal, obstacles, points))
        return next(tried, None)

    def _reach(self, goal: Array, obstacles: Obstacles, points: Array) -> bool:
        way = over(self._station.arm, self._station.joints(), goal, obstacles, points)
        return way is not None and self._station.follow(way[1:])

    def _along(self, start: Pose, offset: tuple[float, float, float]) -> None:
        path = straight(self._station.arm, self._station.joints(), line(start, offset))
        if path is None or not self._station.follow(path):
            raise Impossible(
                "blocked",
                "The arm could not move straight up or down at the table's middle.",
                "Look what holds it back: the box may not stand where it should, upright.",
            )

    def _close(self, width: float) -> None:
        felt = self._station.grip(0.0)
        if abs(felt - width) > _FELT:
            raise Impossible(
                "nothing held",
                f"The hand closed to {1000 * felt:.0f} mm on a box of {1000 * width:.0f} mm.",
                "Stand the box in the table's middle, its sides along the table's; if it stood"
                " there, the set-up's base is wrong, or the hand opens where it should close.",
            )


def from_above(tool: Array, yaw: float) -> Pose:
    """world_from_tool of a hand that points straight down.

    Args:
        tool: Its origin, metres, shape (3,).
        yaw: Of its x axis about the vertical, radians.
    """
    c, s = math.cos(yaw), math.sin(yaw)
    matrix = np.eye(4)
    matrix[:3, :3] = [[c, s, 0.0], [s, -c, 0.0], [0.0, 0.0, -1.0]]
    matrix[:3, 3] = tool
    return Pose.from_matrix(matrix)


def table_without(setup: Setup) -> Terrain:
    """A table on which nothing stands, the basket beside it."""
    count = round(2 * _REACH / CELL)
    terrain = Terrain(np.zeros((count, count)), np.array([-_REACH, -_REACH]))
    stamp_basket(terrain, setup.basket)
    return terrain


def _table_with(setup: Setup, box: KnownBox) -> Terrain:
    """The same with the box upright in its middle."""
    terrain = table_without(setup)
    reach = float(np.hypot(*box.half[:2])) + _SPARE
    rows, columns = terrain.cells(np.array([[-reach, -reach], [reach, reach]]))
    terrain.heights[rows[0] : rows[1], columns[0] : columns[1]] = box.size[2]
    return terrain


def _about_z(angle: float) -> Array:
    return np.array([math.cos(angle / 2), 0.0, 0.0, math.sin(angle / 2)])
