from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

from probe.types import Array, Pose, quaternion_of
from probe.world.robot import jaco, jaco_ik

LOW = np.array([limits[0] if limits else -math.pi for limits in jaco.LIMITS])
HIGH = np.array([limits[1] if limits else math.pi for limits in jaco.LIMITS])

allowed = st.tuples(*(st.floats(low, high) for low, high in zip(LOW, HIGH, strict=True)))


def apart(one: Array, other: Array) -> float:
    """The largest difference of any two angles, whole turns left aside."""
    difference = (one - other + math.pi) % (2 * math.pi) - math.pi
    return float(np.abs(difference).max())


def test_every_solution_reaches_the_pose_and_the_original_is_among_them() -> None:
    for joints in np.random.default_rng(7).uniform(LOW, HIGH, (300, 6)):
        pose = jaco.forward(joints)
        solutions = jaco_ik.inverse(pose)
        for solution in solutions:
            assert np.abs(jaco.forward(solution).matrix - pose.matrix).max() < 1e-6
            assert (solution >= LOW - 1e-9).all() and (solution <= HIGH + 1e-9).all()
        assert min(apart(solution, joints) for solution in solutions) < 1e-6


def test_there_are_eight_branches_well_inside_the_workspace() -> None:
    solutions = jaco_ik.inverse(jaco.forward(np.array([0.3, 2.6, 1.4, 0.4, 2.2, -0.6])))
    assert len(solutions) == 8
    assert len({tuple(np.round(s, 4)) for s in solutions}) == 8
    assert [s.tolist() for s in solutions] == sorted(s.tolist() for s in solutions)


@given(joints=allowed)
def test_any_pose_of_the_arm_has_a_solution(joints: tuple[float, ...]) -> None:
    pose = jaco.forward(np.array(joints))
    solutions = jaco_ik.inverse(pose)
    assert solutions
    for solution in solutions:
        np.testing.assert_allclose(jaco.forward(solution).matrix, pose.matrix, atol=1e-6)


def test_straight_wrist_is_solved_with_joint_6_at_zero() -> None:
    straight = np.array([0.2, 2.5, 1.3, 0.9, math.pi, 0.0])
    solutions = jaco_ik.inverse(jaco.forward(straight))
    assert any(apart(solution, straight) < 1e-6 for solution in solutions)


def test_out_of_reach_is_empty() -> None:
    assert jaco_ik.inverse(Pose((1.2, 0.0, 0.3))) == []
    assert jaco_ik.inverse(Pose((0.05, 0.0, 0.3))) == []


@pytest.mark.slow
def test_what_has_no_solution_is_not_found_by_search_either() -> None:
    rng = np.random.default_rng(11)
    starts = rng.uniform(LOW + 0.01, HIGH - 0.01, (12, 6))
    missed = [
        pose for pose in (over_the_table(rng) for _ in range(60)) if not jaco_ik.inverse(pose)
    ]
    assert 3 <= len(missed) <= 40
    assert not any(searched(pose, starts) for pose in missed[:8])


def over_the_table(rng: np.random.Generator) -> Pose:
    """A pose of the hand before the arm, at most 75 degrees from straight down."""
    down = Rotation.from_euler("ZYZ", [rng.uniform(0, 6.3), 3.14 - rng.uniform(0, 1.3), 0.5])
    point = rng.uniform((0.1, -0.35, 0.1), (0.75, 0.35, 0.5))
    return Pose.of(point, quaternion_of(down.as_matrix()))


def searched(pose: Pose, starts: Array) -> bool:
    """Whether damped least squares within the limits gets there from any start."""
    low, high = LOW.copy(), HIGH.copy()
    low[[0, 3, 5]], high[[0, 3, 5]] = -10.0, 10.0

    def off(joints: Array) -> Array:
        return (jaco.forward_matrix(joints) - pose.matrix)[:3].ravel()

    return any(
        np.abs(off(least_squares(off, start, bounds=(low, high)).x)).max() < 1e-5
        for start in starts
    )
