"""Joints, hands and stops that go wrong, each seen in what the arm really did."""

from __future__ import annotations

import itertools
import time
from typing import Iterator, List, Sequence, Tuple

import pytest

from bridges import TOKEN, Running, quick, running
from faults import FaultyDriver, plant
from probe_bridge.checks.hand import check_hand
from probe_bridge.checks.joints import check_joints
from probe_bridge.checks.stopping import check_cut, check_stop, check_watchdog
from probe_bridge.client import Motion, RobotClient
from probe_bridge.lease import LEASE
from probe_bridge.trajectory import Trajectory


@pytest.fixture
def hasty() -> Iterator[Running]:
    with running(quick(3.0)) as bridge:
        yield bridge


@pytest.fixture
def mover(hasty: Running) -> Iterator[RobotClient]:
    client = RobotClient(hasty.address, TOKEN)
    yield client
    client.close()


@pytest.mark.parametrize("seed", range(4))
def test_swapped_axes(hasty: Running, mover: RobotClient, seed: int):
    plant(hasty.robot, "swapped axes", seed)
    outcome = check_joints(mover)
    assert outcome.fault == "swapped axes"
    names = [joint.name for joint in mover.description.joints]
    assert sum(name in outcome.text for name in names) == 2


def test_a_joint_that_turns_the_wrong_way(hasty: Running, mover: RobotClient):
    class Backwards(FaultyDriver):
        def start(self, trajectory: Trajectory) -> None:
            first = trajectory.joints[0]
            rows = tuple((2 * first[0] - row[0], *row[1:]) for row in trajectory.joints)
            speeds = tuple((-row[0], *row[1:]) for row in trajectory.velocities)
            self.well.start(Trajectory(trajectory.times, rows, speeds))

    driver = Backwards(hasty.driver)
    hasty.robot._driver = hasty.robot._mover._driver = driver
    outcome = check_joints(mover)
    assert outcome.fault == "joint inverted"
    assert outcome.measures[0].value == pytest.approx(-0.05)


def test_the_arm_rests_where_it_was_when_asked_to_stop(hasty: Running, mover: RobotClient):
    for check in (check_stop, check_watchdog):
        began = time.monotonic()
        outcome = check(mover)
        assert outcome.verdict == "passed", outcome.text
        assert hasty.driver.stops[0] > began
        hasty.driver.stops.clear()
        assert max(e.seconds for e in hasty.driver.executed) < 2.5  # of 4 s


def test_a_stall_before_the_hand_turns(
    hasty: Running, mover: RobotClient, monkeypatch: pytest.MonkeyPatch
):
    asked, joints, begin = itertools.count(), mover.joints, mover.begin
    begun: List[int] = []

    def late() -> Tuple[float, ...]:
        """The second answer is as old as it is late, so no lease is renewed meanwhile."""
        answer = joints()
        if next(asked) == 1:
            time.sleep(2 * LEASE)
        return answer

    def counted(path: Sequence[Sequence[float]]) -> Motion:
        begun.append(len(path))
        return begin(path)

    monkeypatch.setattr(mover, "joints", late)
    monkeypatch.setattr(mover, "begin", counted)
    outcome = check_stop(mover)
    assert outcome.verdict == "passed", outcome.text
    assert len(begun) >= 2


@pytest.mark.slow
def test_an_arm_that_does_not_stop(hasty: Running, mover: RobotClient):
    plant(hasty.robot, "no stop", 0)
    outcome = check_stop(mover)
    assert outcome.fault == "no stop"
    outcome = check_watchdog(mover)
    assert outcome.fault == "no stop"


def test_a_cut_link_stops_it(hasty: Running):
    client = RobotClient(hasty.address, TOKEN)
    outcome, again = check_cut(client, lambda: RobotClient(hasty.address, TOKEN))
    again.close()
    assert outcome.verdict == "passed", outcome.text
    assert hasty.driver.executed[-1].seconds < 2.5


def test_an_inverted_hand(hasty: Running, mover: RobotClient):
    plant(hasty.robot, "gripper inverted", 0)
    outcome = check_hand(mover)
    assert outcome.fault == "gripper inverted"
    wide, _, shut, most = (measure.value for measure in outcome.measures)
    assert (wide, shut, most) == (0.0, 128.5, 128.5)


def test_a_hand_that_holds_something(hasty: Running, mover: RobotClient):
    class Holding(FaultyDriver):
        def start_grip(self, opening: float) -> None:
            self.well.start_grip(max(opening, 0.05))

    hasty.robot._driver = hasty.robot._mover._driver = Holding(hasty.driver)
    assert "has to be empty" in check_hand(mover).text
