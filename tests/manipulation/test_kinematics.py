from __future__ import annotations

import numpy as np
import pytest

from probe.manipulation.kinematics import between, either_way, line, reaching, straight
from probe.scene.setup import ArmMount
from probe.station.jaco import Jaco
from probe.station.ur5 import Ur5
from probe.types import Pose

ARM = Ur5()
DOWN = Pose((0.05, -0.1, 0.35), (0.0, 1.0, 0.0, 0.0))


def test_a_line_ends_where_it_should_in_small_steps() -> None:
    poses = line(DOWN, (0.03, 0.0, -0.07))
    places = np.array([DOWN.position, *(p.position for p in poses)])
    assert places[-1] == pytest.approx([0.08, -0.1, 0.28])
    assert np.linalg.norm(np.diff(places, axis=0), axis=1).max() <= 0.02


def test_a_straight_path_keeps_the_hand_on_its_line_and_the_arm_in_its_branch() -> None:
    poses = line(DOWN, (0.0, 0.15, -0.05))
    start = reaching(ARM, DOWN, ARM.parked)[0]
    path = straight(ARM, start, poses)
    assert path is not None
    for joints, pose in zip(path, poses, strict=True):
        assert ARM.forward(joints).matrix == pytest.approx(pose.matrix, abs=1e-6)
    assert np.abs(np.diff(np.vstack([start, path]), axis=0)).max() < 0.2


def test_no_path_leads_out_of_reach() -> None:
    start = reaching(ARM, DOWN, ARM.parked)[0]
    assert straight(ARM, start, line(DOWN, (1.5, 0.0, 0.0))) is None


def test_solutions_come_nearest_first() -> None:
    distances = [np.abs(j - ARM.parked).max() for j in reaching(ARM, DOWN, ARM.parked)]
    assert distances == sorted(distances) and len(distances) > 1


def test_swapped_fingers_lie_in_the_same_places() -> None:
    one, other = either_way(DOWN)
    tips = np.array([[0.0, 0.05, 0.2], [0.0, -0.05, 0.2]])
    assert one.apply(tips) == pytest.approx(other.apply(tips)[::-1])


def test_between_keeps_the_waypoints_and_the_step() -> None:
    path = between(np.array([[0.0, 0.0], [1.0, 0.2], [1.0, 0.3]]), step=0.3)
    assert np.abs(np.diff(path, axis=0)).max() <= 0.3 + 1e-12
    assert [1.0, 0.2] in path.tolist() and path[-1].tolist() == [1.0, 0.3]


def test_joints_without_stops_are_turned_the_short_way() -> None:
    jaco = Jaco(ArmMount(Pose((-0.4, 0.0, 0.0)), (0.0, 3.1, 1.2, 0.0, 3.0, 0.0), "jaco"))
    # Its first joint counts from -pi to pi, and straight ahead is where it goes over.
    near = np.array([3.0, 3.1, 4.6, 0.0, 3.6, 0.0])
    start = next(joints for joints in reaching(jaco, DOWN, near) if abs(joints[0] - np.pi) < 0.6)
    path = straight(jaco, start, line(DOWN, (0.0, 0.25, 0.0)))
    assert path is not None
    assert path[:, 0].min() < np.pi < path[:, 0].max()
    assert np.abs(np.diff(np.vstack([start, path]), axis=0)).max() < 0.2
