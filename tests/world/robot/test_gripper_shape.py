from __future__ import annotations

import mujoco
import numpy as np
import pytest

from probe.types import Array
from probe.world.robot import gripper
from probe.world.robot.gripper_shape import boxes
from world.robot.rig import Rig, world

PARTS = ("palm", "crank", "finger", "pad")


def surface(rig: Rig, geom: int) -> Array:
    """Points over a box's or cylinder's hull in the world frame, shape (n, 3)."""
    half = np.array(rig.model.geom_size[geom])
    if rig.model.geom_type[geom] == mujoco.mjtGeom.mjGEOM_CYLINDER:
        turn = np.linspace(0, 2 * np.pi, 24)
        ring = half[0] * np.column_stack([np.cos(turn), np.sin(turn), np.zeros(24)])
        grid = np.concatenate([ring + [0, 0, z] for z in np.linspace(-half[1], half[1], 9)])
    else:
        steps = np.array(np.meshgrid(*[np.linspace(-1, 1, 9)] * 3)).reshape(3, -1).T
        grid = steps * half
    rotation = rig.data.geom_xmat[geom].reshape(3, 3)
    return grid @ rotation.T + rig.data.geom_xpos[geom]


@pytest.mark.parametrize("opening", [0.0, 0.03, 0.08, 0.128])
def test_boxes_enclose_the_model(opening: float) -> None:
    rig = Rig.of(world())
    rig.set_gripper(gripper.joint_for(opening))
    mujoco.mj_kinematics(rig.model, rig.data)
    occupied = boxes(opening)
    for geom in range(rig.model.ngeom):
        name = rig.model.geom(geom).name.removeprefix("robot/")
        if any(part in name for part in PARTS):
            points = rig.tool().inverse().apply(surface(rig, geom))
            inside = [(np.abs(points - c) <= h + 1e-6).all(axis=1) for c, h in occupied]
            assert np.any(inside, axis=0).all(), name


@pytest.mark.parametrize("opening", [0.01, 0.06, 0.12])
def test_boxes_leave_room_for_what_is_held(opening: float) -> None:
    reach = gripper.pad_reach(gripper.joint_for(opening))
    held = np.array([0.0, 0.0, reach]), np.array([0.05, opening / 2 - 1e-6, 0.03])
    for centre, half in boxes(opening):
        apart = np.abs(centre - held[0]) >= half + held[1]
        assert apart.any()


def test_boxes_are_symmetric() -> None:
    occupied = boxes(0.05)
    mirrored = {tuple(np.round(c * [1, -1, 1], 9)) for c, _ in occupied}
    assert mirrored == {tuple(np.round(c, 9)) for c, _ in occupied}
