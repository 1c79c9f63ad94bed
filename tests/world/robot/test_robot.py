from __future__ import annotations

import itertools
from collections.abc import Iterator

import mujoco
import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from probe.scene.setup import UR5_TABLE, ArmMount
from probe.types import Array, Pose
from probe.world.robot import gripper, ik
from probe.world.robot.robot import GRIPPER_DRIVE, PREFIX, add_robot
from world.robot.rig import ARM_JOINTS, Rig, hand_down, world

NEAR = np.array([0.0, -1.9, 2.2, -1.9, -1.57, 0.0])


def farthest_x(rig: Rig, geom: int) -> float:
    """Largest x of a geom's bounding box, turned with it."""
    centre, half = np.split(rig.model.geom_aabb[geom], 2)
    signs = np.array(list(itertools.product([-1, 1], repeat=3)))
    corners: Array = centre + signs * half
    rotation = rig.data.geom_xmat[geom].reshape(3, 3)
    return float((corners @ rotation.T + rig.data.geom_xpos[geom])[:, 0].max())


def touching(rig: Rig) -> list[tuple[str, str]]:
    contacts = rig.data.contact[: rig.data.ncon]
    return [(rig.model.geom(c.geom1).name, rig.model.geom(c.geom2).name) for c in contacts]


@pytest.mark.parametrize("joint", [0.0, 0.35, 0.7])
def test_parked_robot_is_out_of_the_picture_and_touches_nothing(joint: float) -> None:
    rig = Rig.of(world())
    rig.set_gripper(joint)
    mujoco.mj_forward(rig.model, rig.data)
    robot = [g for g in range(rig.model.ngeom) if rig.model.geom(g).name.startswith(PREFIX)]
    assert max(farthest_x(rig, geom) for geom in robot) < -0.42
    assert [pair for pair in touching(rig) if "pad" not in pair[0]] == []


@pytest.mark.parametrize(
    ("tilt_deg", "directions", "share"), [(0, 1, 1.0), (30, 6, 0.9), (60, 6, 0.8)]
)
def test_work_area_is_reached_free_of_collisions(
    tilt_deg: float, directions: int, share: float
) -> None:
    model = world().compile()
    rig = Rig(model, mujoco.MjData(model))
    joint = gripper.joint_for(0.06)
    rig.set_gripper(joint)
    axis = np.linspace(-0.3, 0.3, 5)
    found: dict[tuple[float, ...], list[bool]] = {}
    for point in itertools.product(axis, axis, (0.04, 0.15, 0.3)):
        for heading in np.arange(directions) * 2 * np.pi / directions:
            poses = hand_poses(point, np.radians(tilt_deg), heading, gripper.pad_reach(joint))
            found.setdefault(point, []).append(reached(rig, poses))
    assert all(any(reachable) for reachable in found.values())
    assert np.mean(list(found.values())) >= share


def hand_poses(
    point: tuple[float, ...], tilt: float, heading: float, reach: float
) -> Iterator[Pose]:
    """The hand tilted from straight down, its fingers turned in steps of 45 degrees."""
    for turn in np.arange(4) * np.pi / 4:
        rotation = Rotation.from_euler("ZYZ", [heading, np.pi - tilt, turn])
        position = np.asarray(point) - reach * rotation.as_matrix()[:, 2]
        yield Pose.of(position, rotation.as_quat(scalar_first=True))


def reached(rig: Rig, poses: Iterator[Pose]) -> bool:
    for pose in poses:
        for joints in ik.inverse(UR5_TABLE.mount.base.inverse() @ pose):
            rig.data.qpos[rig.arm] = joints
            mujoco.mj_forward(rig.model, rig.data)
            if not touching(rig):
                return True
    return False


def test_the_hand_reaches_the_basket_beside_the_work_area() -> None:
    for point in itertools.product((-0.25, -0.05), (-0.55,), (0.15, 0.3)):
        rig = Rig.of(world(), hand_down(point, 0.2, NEAR))
        assert touching(rig) == []


def test_robot_joins_a_world_that_counts_angles_in_degrees() -> None:
    spec = mujoco.MjSpec()
    hinge = spec.worldbody.add_body(name="lid")
    hinge.add_joint(name="lid", type=mujoco.mjtJoint.mjJNT_HINGE, range=[0, 90])
    hinge.add_geom(size=[0.1, 0, 0])
    add_robot(spec, ArmMount(Pose((1.0, 0.0, 0.0))), UR5_TABLE.gripper)
    model = spec.compile()
    assert model.joint("lid").range[1] == pytest.approx(np.pi / 2)
    assert model.joint(ARM_JOINTS[2]).range[1] == pytest.approx(np.pi)
    names = {model.actuator(i).name for i in range(model.nu)}
    assert names == {*ARM_JOINTS, GRIPPER_DRIVE}


def test_same_steps_give_the_same_state() -> None:
    states: list[Array] = []
    for _ in range(2):
        rig = Rig.of(world())
        rig.grip(0.5)
        rig.move(np.array(UR5_TABLE.mount.parked) + 0.3, 1.0)
        states.append(rig.data.qpos.copy())
    np.testing.assert_array_equal(states[0], states[1])
