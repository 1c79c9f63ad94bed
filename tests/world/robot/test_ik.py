from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from probe.types import Array, Pose
from probe.world.robot import ik, ur5

angles = st.lists(st.floats(-math.pi, math.pi), min_size=6, max_size=6).map(np.array)


def random_joints(count: int) -> Array:
    return np.random.default_rng(7).uniform(-math.pi, math.pi, (count, 6))


def test_every_solution_reaches_the_pose_and_the_original_is_among_them() -> None:
    for joints in random_joints(1000):
        pose = ur5.forward(joints)
        solutions = ik.inverse(pose)
        for solution in solutions:
            assert np.abs(ur5.forward(solution).matrix - pose.matrix).max() < 1e-6
            assert (np.abs(solution) <= math.pi).all()
        nearest = min(np.abs(solution - joints).max() for solution in solutions)
        assert nearest < 1e-6


def test_there_are_eight_branches_well_inside_the_workspace() -> None:
    solutions = ik.inverse(ur5.forward(np.array([0.3, -1.4, 1.6, -1.8, -1.3, 0.4])))
    assert len(solutions) == 8
    assert len({tuple(np.round(s, 4)) for s in solutions}) == 8
    assert [s.tolist() for s in solutions] == sorted(s.tolist() for s in solutions)


@given(joints=angles)
def test_any_pose_with_a_bent_wrist_has_a_solution(joints: Array) -> None:
    assume(abs(math.sin(joints[4])) > 1e-4)
    pose = ur5.forward(joints)
    solutions = ik.inverse(pose)
    assert solutions
    for solution in solutions:
        np.testing.assert_allclose(ur5.forward(solution).matrix, pose.matrix, atol=1e-6)


def test_straight_wrist_is_solved_with_wrist_3_at_zero() -> None:
    solutions = ik.inverse(ur5.forward(np.array([0.2, -1.4, 1.6, -0.7, 0.0, 0.0])))
    assert any(np.allclose(s, [0.2, -1.4, 1.6, -0.7, 0.0, 0.0], atol=1e-6) for s in solutions)


def test_out_of_reach_is_empty() -> None:
    assert ik.inverse(Pose((1.2, 0.0, 0.3))) == []
    assert ik.inverse(Pose((0.0, 0.0, 0.5))) == []


@given(joints=angles, turns=st.lists(st.integers(-1, 1), min_size=6, max_size=6))
def test_nearest_finds_the_way_back_through_whole_turns(joints: Array, turns: list[int]) -> None:
    reference = joints + 2 * math.pi * np.array(turns) * (ur5.JOINT_LIMIT > 4)
    reference = np.clip(reference, -ur5.JOINT_LIMIT, ur5.JOINT_LIMIT)
    goal = np.clip(reference + 0.01, -ur5.JOINT_LIMIT, ur5.JOINT_LIMIT)
    found = ik.nearest([ik.wrap(goal)], reference)
    np.testing.assert_allclose(found, goal, atol=1e-9)


def test_nearest_needs_a_solution() -> None:
    with pytest.raises(ValueError, match="empty"):
        ik.nearest([], np.zeros(6))
