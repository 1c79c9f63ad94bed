"""The table with the robot at it, in motion: step, command, look at poses, save and restore."""

from __future__ import annotations

import copy
from dataclasses import dataclass, replace

import mujoco
import numpy as np

from probe.assets.library import Library
from probe.scene.scene import PlacedObject, Scene
from probe.scene.setup import Setup
from probe.types import Array, Pose
from probe.world.model import GHOST_BIT, TIME_STEP, Item, build_cell
from probe.world.robot.arm_model import servo_command
from probe.world.robot.gripper import joint_for, opening
from probe.world.robot.robot import GRIPPER_DRIVE, GRIPPER_JOINT, arm_joints

_ABOVE = 0.02
"""Metres over the basket's floor at which something that is taken away is let go."""

_NEAR = 0.005


@dataclass(frozen=True, eq=False)
class Snapshot:
    """Everything the physics needs to go on exactly as it would have; for the world it is of."""

    data: mujoco.MjData


class World:
    """A Scene brought to life, the arm parked and the gripper open."""

    def __init__(self, scene: Scene, library: Library) -> None:
        items = [
            Item(placed.instance, library[placed.object_id], library.form(placed.object_id))
            for placed in scene.objects
        ]
        self._scene = scene
        self._model = build_cell(items, {o.instance: o.pose for o in scene.objects}, scene.setup)
        self._data = mujoco.MjData(self._model)
        joints = arm_joints(scene.setup.mount.arm)
        self._arm_qpos = [int(self._model.joint(name).qposadr[0]) for name in joints]
        self._arm_dof = [int(self._model.joint(name).dofadr[0]) for name in joints]
        self._arm_servo = [int(self._model.actuator(name).id) for name in joints]
        self._grip_qpos = int(self._model.joint(GRIPPER_JOINT).qposadr[0])
        self._grip_drive = int(self._model.actuator(GRIPPER_DRIVE).id)
        self._object_qpos = {
            item.instance: int(self._model.joint(item.name).qposadr[0]) for item in items
        }
        self._corners = {
            item.instance: np.concatenate([piece.vertices for piece in item.body.pieces])
            for item in items
        }
        self._data.qpos[self._arm_qpos] = scene.setup.mount.parked
        self._data.ctrl[self._arm_servo] = scene.setup.mount.parked
        mujoco.mj_forward(self._model, self._data)

    @property
    def setup(self) -> Setup:
        """What stands around the objects."""
        return self._scene.setup

    @property
    def time(self) -> float:
        """Simulated seconds since the beginning."""
        return float(self._data.time)

    @property
    def joints(self) -> Array:
        """Angles of the arm's joints, radians, shape (6,)."""
        return self._data.qpos[self._arm_qpos].copy()

    @property
    def joint_speeds(self) -> Array:
        """Speeds of the arm's joints, radians a second, shape (6,)."""
        return self._data.qvel[self._arm_dof].copy()

    @property
    def opening(self) -> float:
        """Distance between the pads, metres."""
        return opening(float(self._data.qpos[self._grip_qpos]), self.setup.gripper)

    def command(self, joints: Array, velocities: Array) -> None:
        """Where the arm should be now and how fast it should move, shapes (6,)."""
        self._data.ctrl[self._arm_servo] = servo_command(joints, velocities)

    def command_opening(self, metres: float) -> None:
        """Distance between the pads that the gripper should take up."""
        self._data.ctrl[self._grip_drive] = joint_for(metres, self.setup.gripper)

    def step(self, count: int = 1) -> None:
        """Advance by so many time steps of TIME_STEP seconds."""
        mujoco.mj_step(self._model, self._data, count)

    def object_speed(self) -> float:
        """Fastest linear speed of any object, metres a second."""
        speeds = [
            float(np.linalg.norm(self._data.body(f"object/{number}").cvel[3:]))
            for number in self._object_qpos
        ]
        return max(speeds, default=0.0)

    def take_away(self, instance: int) -> None:
        """Move an object into the basket, where nothing touches it any more.

        What it touched wakes up and falls from now on.
        """
        for other in self._object_qpos:
            if other != instance and self._are_near(instance, other):
                # A sleeping body only notices that it may fall when it moves.
                self._data.qvel[self._dof(other) + 2] -= 1e-6
        body = int(self._model.body(f"object/{instance}").id)
        geoms = self._model.geom_bodyid == body
        self._model.geom_contype[geoms], self._model.geom_conaffinity[geoms] = GHOST_BIT, 0
        low, high = self._bounds(instance)
        middle = np.array([*(low + high)[:2] / 2, low[2]])
        at, dof = self._object_qpos[instance], self._dof(instance)
        self._data.qpos[at : at + 3] += (
            np.add(self.setup.basket.position, (0.0, 0.0, _ABOVE)) - middle
        )
        self._data.qvel[dof : dof + 6] = (0.0, 0.0, -1e-6, 0.0, 0.0, 0.0)
        mujoco.mj_forward(self._model, self._data)

    def scene(self) -> Scene:
        """The table as it is now."""
        objects = tuple(
            PlacedObject(placed.instance, placed.object_id, self._pose(placed.instance))
            for placed in self._scene.objects
        )
        return replace(self._scene, objects=objects)

    def save(self) -> Snapshot:
        """The exact state; restoring it gives the same future, bit for bit."""
        # All of it, not the engine's state vector: a body that falls asleep keeps the frame it had
        # one step earlier, and its neighbours' contacts depend on that.
        return Snapshot(copy.copy(self._data))

    def restore(self, snapshot: Snapshot) -> None:
        """Go back to a saved state of this world."""
        mujoco.mj_copyData(self._data, self._model, snapshot.data)

    def _are_near(self, one: int, other: int) -> bool:
        """Whether the boxes around two objects meet."""
        (low, high), (other_low, other_high) = self._bounds(one), self._bounds(other)
        return bool((low < other_high + _NEAR).all() and (other_low < high + _NEAR).all())

    def _bounds(self, instance: int) -> tuple[Array, Array]:
        """Lowest and highest corner of the collision shape, each of shape (3,)."""
        corners = self._pose(instance).apply(self._corners[instance])
        return corners.min(axis=0), corners.max(axis=0)

    def _dof(self, instance: int) -> int:
        return int(self._model.joint(f"object/{instance}").dofadr[0])

    def _pose(self, instance: int) -> Pose:
        at = self._object_qpos[instance]
        return Pose.of(self._data.qpos[at : at + 3], self._data.qpos[at + 3 : at + 7])


__all__ = ["TIME_STEP", "Snapshot", "World"]
