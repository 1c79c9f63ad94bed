from __future__ import annotations

import math

import mujoco
import numpy as np
import pytest

from probe.types import Array
from probe.world.robot import gripper
from probe.world.robot.robot import GRIPPER_DRIVE, PADS
from world.robot.rig import Rig, hand_down, world

NEAR = np.array([0.0, -1.9, 2.2, -1.9, -1.57, 0.0])
INTEGRATORS = [mujoco.mjtIntegrator.mjINT_EULER, mujoco.mjtIntegrator.mjINT_IMPLICITFAST]


def pads(rig: Rig) -> list[tuple[Array, Array]]:
    """Centre and rotation of the left and right pad in the frame of tool0."""
    tool = rig.tool()
    found: list[tuple[Array, Array]] = []
    for name in PADS:
        geom = rig.data.geom(name)
        centre = tool.inverse().apply(geom.xpos[None])[0]
        found.append((centre, tool.rotation.T @ geom.xmat.reshape(3, 3)))
    return found


@pytest.mark.parametrize("integrator", INTEGRATORS)
def test_pads_open_as_stated_and_stay_parallel(integrator: int) -> None:
    rig = Rig.of(world(integrator))
    for command in [*np.linspace(0, 0.7, 8), 0.35, 0.0]:
        rig.grip(command)
        rig.wait(1.0)
        (left, left_turn), (right, right_turn) = pads(rig)
        gap = right[1] - left[1] - gripper.PAD_THICKNESS
        assert gap == pytest.approx(gripper.opening(command), abs=2e-3)
        assert left[2] == pytest.approx(gripper.pad_reach(command), abs=1e-3)
        assert left[1] + right[1] == pytest.approx(0.0, abs=5e-4)
        for turn in (left_turn, right_turn):
            assert math.degrees(math.acos(min(1.0, turn[2, 2]))) < 0.5


def test_fingers_keep_parallel_and_below_their_speed_while_they_close() -> None:
    rig = Rig.of(world())
    rig.grip(gripper.JOINT_LIMIT)
    fastest, place = 0.0, pads(rig)[0][0][1]
    for _ in range(300):
        rig.wait(0.003)
        (left, turn), _ = pads(rig)
        fastest, place = max(fastest, (left[1] - place) / 0.003), left[1]
        assert math.degrees(math.acos(min(1.0, turn[2, 2]))) < 0.5
    assert 0.8 * gripper.FINGER_SPEED < fastest < 1.05 * gripper.FINGER_SPEED
    assert gripper.opening(rig.gripper) < 2e-3


def rig_around(
    half: tuple[float, float, float], mass: float, integrator: int, offset: float = 0.0
) -> tuple[Rig, float, float]:
    """The open hand around a box on the table; with the joint that touches it and the height."""
    spec = world(integrator)
    thing = spec.worldbody.add_body(name="thing", pos=[offset, 0.0, half[2]])
    thing.add_freejoint()
    thing.add_geom(
        type=mujoco.mjtGeom.mjGEOM_BOX, size=half, mass=mass, friction=[0.5, 0.005, 1e-4]
    )
    joint, height = gripper.joint_for(2 * half[1]), max(half[2], 0.04)
    rig = Rig.of(spec, hand_down((0.0, 0.0, height), gripper.pad_reach(joint), NEAR))
    rig.wait(0.1)
    rig.grip(gripper.JOINT_LIMIT)
    rig.wait(0.9)
    return rig, joint, height


def pad_force(rig: Rig, pad: str) -> float:
    """Sum of the normal forces between a pad and the thing, newtons."""
    total, wrench = 0.0, np.zeros(6)
    for index in range(rig.data.ncon):
        if rig.model.geom(pad).id in rig.data.contact[index].geom:
            mujoco.mj_contactForce(rig.model, rig.data, index, wrench)
            total += wrench[0]
    return total


@pytest.mark.parametrize("half_width", [0.003, 0.025, 0.055])
def test_grip_force_lies_in_the_makers_range(half_width: float) -> None:
    rig, _, _ = rig_around((0.03, half_width, 0.04), 0.3, INTEGRATORS[0])
    low, high = gripper.FORCE_RANGE
    for pad in PADS:
        assert low < pad_force(rig, pad) < high
    drive = rig.model.actuator(GRIPPER_DRIVE).forcerange[1]
    tilt = math.cos(gripper.TILT - rig.gripper)
    expected = (
        drive / 2 / (gripper.crank(gripper.ROBOTIQ_2F140) * tilt)
    )  # virtual work on a parallelogram
    assert pad_force(rig, PADS[0]) == pytest.approx(expected, rel=0.1)


@pytest.mark.parametrize("integrator", INTEGRATORS)
@pytest.mark.parametrize(
    ("mass", "half", "offset"),
    [
        (0.02, (0.03, 0.015, 0.03), 0.0),
        (0.1, (0.03, 0.025, 0.04), 0.0),
        (0.3, (0.03, 0.004, 0.04), 0.0),
        (0.5, (0.03, 0.055, 0.035), 0.0),
        (1.0, (0.03, 0.025, 0.04), 0.0),
        (1.0, (0.08, 0.025, 0.04), 0.02),
    ],
)
def test_friction_alone_holds_and_carries_a_box(
    mass: float, half: tuple[float, float, float], offset: float, integrator: int
) -> None:
    rig, joint, height = rig_around(half, mass, integrator, offset)
    held = rig.tool().inverse() @ rig.body("thing")
    for step in range(1, 11):
        point = (0.0, 0.0, height + 0.02 * step)
        rig.move(hand_down(point, gripper.pad_reach(joint), rig.joints), 0.5)
    rig.wait(1.0)
    rig.move(rig.joints + np.array([1.0, 0, 0, 0, 0, 0]), math.radians(90))
    rig.wait(0.5)
    still_held = rig.tool().inverse() @ rig.body("thing")
    slip = np.linalg.norm(np.subtract(held.position, still_held.position))
    assert slip < 5e-3
    assert rig.body("thing").position[2] == pytest.approx(half[2] + 0.2, abs=5e-3)
    deepest = min(contact.dist for contact in rig.data.contact[: rig.data.ncon])
    assert deepest > -1e-3
