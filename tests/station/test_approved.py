"""Motions that a person approves, refuses or stops, on a bridge whose arm is only computed."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable

import numpy as np
import pytest

from probe.errors import StoppedByPerson
from probe.station.approved import Approved, Over, PlannedMotion
from probe.station.emergency_stop import EmergencyStop
from probe.station.path_picture import path_picture, tip_of
from probe.station.stoppable import Stoppable
from probe.types import Pose
from station.test_remote import FILE, PARKED, _speeds, station

AWAY = PARKED + (0.2, 0.1, -0.1, 0, 0, 0.1)


class Person:
    """Answers as told, and remembers what was asked."""

    def __init__(self, says: Callable[[int], bool] = lambda _: True) -> None:
        self.says = says
        self.asked: list[PlannedMotion] = []

    def __call__(self, motion: PlannedMotion, over: Over) -> bool:
        self.asked.append(motion)
        return self.says(motion.number)


def going_on() -> bool:
    """Nobody has stopped it."""
    return False


def test_every_motion_is_asked_for_with_its_words_and_its_picture() -> None:
    person = Person()
    with station() as (robot, bridge):
        careful = Approved(robot, person, robot.glance, going_on)
        before = careful.observe(rgb=True)
        assert careful.follow(np.array([AWAY]))
        careful.grip(0.03)
        careful.grip(0.03)  # nothing new is commanded
        careful.grip(0.0)
        assert careful.follow(np.array([PARKED]))
        assert np.allclose(careful.joints(), PARKED, atol=1e-6)
        tip = tip_of(robot.arm, robot.hand, AWAY)
    assert [motion.number for motion in person.asked] == [1, 2, 3, 4]
    assert f"x {tip[0]:.2f}, y {tip[1]:.2f}, z {tip[2]:.2f} m" in person.asked[0].words
    assert "11 degrees" in person.asked[0].words and "30 mm" in person.asked[1].words
    assert before.rgb is not None
    assert all(motion.picture.shape == before.rgb.shape for motion in person.asked)
    assert len(bridge.driver.moves) == 2


def test_a_refused_motion_moves_nothing_and_is_no_blocked_one() -> None:
    with station() as (robot, bridge):
        careful = Approved(robot, Person(lambda number: number != 2), robot.glance, going_on)
        careful.follow(np.array([AWAY]))
        with pytest.raises(StoppedByPerson, match="refused motion 2"):
            careful.follow(np.array([PARKED]))
        assert np.allclose(robot.joints(), AWAY, atol=1e-6)
        assert len(bridge.driver.moves) == 1


def test_the_line_runs_where_the_fingertips_go() -> None:
    with station() as (robot, _):
        frame = robot.observe(rgb=True)
        ends = [min(robot.arm.inverse(over(x)), key=lambda q: abs(q - PARKED).max())
                for x in (-0.1, 0.1)]  # fmt: skip
        picture = path_picture(frame, robot.arm, robot.hand, np.array(ends))
        red = (picture == (255, 60, 0)).all(axis=-1)
        for share in (0.0, 0.25, 0.5, 0.75, 1.0):
            joints = ends[0] + share * (ends[1] - ends[0])
            ((u, v),) = frame.camera.project(tip_of(robot.arm, robot.hand, joints)[None])
            assert 0 < u < 1024 and 0 < v < 1024
            away = np.abs(np.argwhere(red) - (v, u)).max(axis=1).min()
            assert away < (4 if share < 1 else 40)  # a ring is around the end
        assert (picture == (90, 220, 255)).all(axis=-1).any()
        assert (picture != frame.rgb).any(axis=-1).mean() < 0.2


def over(x: float) -> Pose:
    """The tool above the table, its z downwards."""
    return Pose((x, 0.05, 0.35), (0.0, 1.0, 0.0, 0.0))


def test_a_stop_halts_the_motion_under_way_and_all_that_follows_until_its_release() -> None:
    with station({**FILE, **_speeds(0.3)}) as (robot, bridge):
        stop = EmergencyStop([robot.stop], robot.release)
        watched = Stoppable(robot, stop)
        pressed: list[float] = []

        def press() -> None:
            pressed.append(time.monotonic())
            stop.press("the page")

        threading.Timer(0.4, press).start()
        with pytest.raises(StoppedByPerson, match="stopped the robot by the page"):
            watched.follow(np.array([PARKED + (1.0, 0, 0, 0, 0, 0)]))
        assert bridge.driver.stops[0] - pressed[0] < 0.4
        rest = robot.joints()
        assert PARKED[0] < rest[0] < PARKED[0] + 0.9
        moves = len(bridge.driver.moves)
        for act in (
            lambda: watched.follow(np.array([PARKED])),
            lambda: watched.grip(0.0),
            lambda: watched.observe(rgb=False),
            watched.joints,
        ):
            with pytest.raises(StoppedByPerson):
                act()
        assert len(bridge.driver.moves) == moves and np.allclose(robot.joints(), rest)
        stop.release()
        # For whoever saw the stop the episode is over; the next one may move.
        with pytest.raises(StoppedByPerson, match="in this episode, and released it"):
            watched.follow(np.array([PARKED]))
        assert len(bridge.driver.moves) == moves
        assert Stoppable(robot, stop).follow(np.array([PARKED]))


def test_the_first_motions_are_slow() -> None:
    with station() as (robot, bridge):
        robot._slow = 2
        for goal in (AWAY, PARKED, AWAY):
            robot.follow(np.array([goal]))
        first, second, third = (motion.duration for motion, _ in bridge.driver.executed)
        assert first == pytest.approx(4 * third, rel=0.01)
        assert second == pytest.approx(4 * third, rel=0.01)
