"""The simulated station: a World to act in and a Renderer to look with."""

from __future__ import annotations

import zlib
from collections.abc import Sequence
from dataclasses import replace
from functools import partial

import numpy as np

from probe.errors import ArmInView
from probe.render.illumination import AMBIENT, Illumination
from probe.render.renderer import Renderer
from probe.scene.scene import PlacedObject, Scene
from probe.station.arms import PEAK_SPEED, arm_of, hand_of
from probe.station.fusing import FRAMES, fused
from probe.station.motion import smooth
from probe.station.station import Arm, Hand
from probe.types import Array, Camera, Frame
from probe.world.world import TIME_STEP, World

BLOCKED = 0.06
"""Radians by which a joint may trail its command before the arm stops, as a real one would."""

_CHECK_EVERY = 5
_STILL = 0.004
_GRIP_TIME = 2.5
_GRIP_STILL = 2e-4
_FALL_TIME = 4.0


class SimulatedStation:
    """A Station in simulation. The renderer must have the scene's objects loaded.

    Only this one has snapshot() and take_away(): no tool can ask a Station for the truth, or
    change it without the arm.

    Args:
        world: What the arm moves.
        renderer: What the camera sees with.
        camera: Where it stands; by default the fixed top-down one.
        light: Of colour pictures.
    """

    def __init__(
        self,
        world: World,
        renderer: Renderer,
        camera: Camera | None = None,
        light: Illumination = AMBIENT,
    ) -> None:
        self.arm: Arm = arm_of(world.setup.mount)
        self.hand: Hand = hand_of(world.setup)
        self._world = world
        self._renderer = renderer
        self._camera = camera or world.setup.camera()
        self._light = light
        self._goal = world.joints
        self._alone_px: dict[Camera, dict[PlacedObject, int]] = {}

    def observe(self, *, rgb: bool) -> Frame:
        """Look at the table with the fixed camera.

        Raises:
            ArmInView: The arm isn't parked, so it would hide part of the table.
        """
        return self._seen_by(self._camera, rgb=rgb)

    def look_into_basket(self, *, rgb: bool) -> Frame:
        """Look into the basket with the camera above it.

        Raises:
            ArmInView: The arm isn't parked.
        """
        return self._seen_by(self._world.setup.basket_camera, rgb=rgb)

    def _seen_by(self, camera: Camera, *, rgb: bool) -> Frame:
        if np.abs(self._world.joints - self.arm.parked).max() > BLOCKED:
            raise ArmInView
        objects = self._world.scene().objects
        frame = self._renderer.draw(objects, camera, rgb=rgb, light=self._light)
        assert frame.labels is not None
        shown = set(np.unique(frame.labels).tolist()) - {0}
        outlines = self._alone([placed for placed in objects if placed.instance in shown], camera)
        counts = np.bincount(frame.labels.ravel())
        shares = {number: counts[number] / size for number, size in outlines.items()}
        painter = None if rgb else partial(self._renderer.paint, objects, camera, self._light)
        return replace(
            self._measured(frame), shares=shares, taken=self._world.time, painter=painter
        )

    def _measured(self, frame: Frame) -> Frame:
        """A frame fused of several with noise; the same table gives the same noise again."""
        noise = self._world.setup.depth_noise
        if noise == 0:
            return frame
        scene = self._world.scene()
        poses = np.array([(*o.pose.position, *o.pose.wxyz) for o in scene.objects])
        rng = np.random.default_rng([scene.seed, zlib.crc32(poses.tobytes())])
        shape = frame.depth.shape
        depths = [frame.depth + noise * rng.standard_normal(shape) for _ in range(FRAMES)]
        told = fused(depths)
        return replace(frame, depth=told.depth, depth_noise=told.noise, measured=told.measured)

    def snapshot(self) -> Scene:
        """The table as it really is."""
        return self._world.scene()

    def take_away(self, instance: int) -> None:
        """Put an object into the basket as by magic; what leaned on it comes to rest."""
        self._world.take_away(instance)
        self.wait(_FALL_TIME)

    def joints(self) -> Array:
        """Joint angles as measured, radians, shape (6,)."""
        return self._world.joints

    def follow(self, path: Array) -> bool:
        """Move through joint angles, shape (m, 6), in one smooth motion, and come to rest.

        Returns:
            Whether the arm got there. It stops where it is as soon as something holds it back.
        """
        speed = PEAK_SPEED[self._world.setup.mount.arm]
        trajectory = smooth(np.vstack([self._goal, path]), speed, TIME_STEP)
        for step, (joints, velocities) in enumerate(
            zip(trajectory.joints, trajectory.velocities, strict=True)
        ):
            self._world.command(joints, velocities)
            self._world.step()
            if step % _CHECK_EVERY == 0 and self._trails(joints):
                self._hold()
                return False
        self._goal = trajectory.joints[-1]
        self._world.step(10)
        return not self._trails(self._goal)

    def grip(self, opening: float) -> float:
        """Open or close the gripper towards an opening in metres, and say what it reached."""
        self._world.command_opening(opening)
        before = self._world.opening
        for _ in range(round(_GRIP_TIME / TIME_STEP / 25)):
            self._world.step(25)
            if abs(self._world.opening - before) < _GRIP_STILL:
                break
            before = self._world.opening
        return self._world.opening

    def wait(self, seconds: float) -> None:
        """Let things come to rest, at most so many seconds."""
        for _ in range(round(seconds / TIME_STEP / 25)):
            self._world.step(25)
            if self._world.object_speed() < _STILL:
                return

    def _alone(self, objects: Sequence[PlacedObject], camera: Camera) -> dict[int, int]:
        """Pixels of each object if it stood there alone; drawn anew only for what has moved."""
        known = self._alone_px.setdefault(camera, {})
        new = [placed for placed in objects if placed not in known]
        if new:
            outlines = self._renderer.outlines(new, camera)
            for placed in new:
                known[placed] = int(np.count_nonzero(outlines[placed.instance]))
        return {placed.instance: known[placed] for placed in objects}

    def _trails(self, joints: Array) -> bool:
        return bool(np.abs(self._world.joints - joints).max() > BLOCKED)

    def _hold(self) -> None:
        """Stay where the arm is."""
        self._goal = self._world.joints
        self._world.command(self._goal, np.zeros_like(self._goal))
        self._world.step(50)
        self._goal = self._world.joints
