"""A World that runs by the clock: in a thread, as a table does whether or not anyone looks."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np

from probe.scene.scene import PlacedObject, Scene
from probe.types import Array
from probe.world.world import TIME_STEP, World

if TYPE_CHECKING:
    from probe_bridge.trajectory import Trajectory

_TICK = 0.005
_AT_ONCE = 40
"""Time steps that are done without letting others look."""

_SETTLE = 0.15
"""Simulated seconds that a motion's end is waited for: servos trail."""

_GRIP_STILL = 0.075
_GRIP_LEAST, _GRIP_MOST = 0.15, 2.5
_GRIP_CREEP = 2e-4


Watch = Callable[[Array, Array], None]
"""Takes the joints' angles, radians, and speeds by the clock, radians a second, shapes (n,)."""


@dataclass(frozen=True, eq=False)
class TwinMoment:
    """All that a camera can see, at one time.

    Attributes:
        objects: Where each is.
        joints: The arm's, radians, shape (n,).
        opening: Distance of the pads, metres.
        stamp: When, by the clock.
    """

    objects: tuple[PlacedObject, ...]
    joints: Array
    opening: float
    stamp: float


@dataclass(frozen=True)
class _Motion:
    """A trajectory under way, and when it began: simulated and real seconds."""

    trajectory: Trajectory
    began: float
    clock: float


class TwinBody:
    """Arm, hand and things in motion. Any thread may call.

    Args:
        world: What moves; nobody else may touch it from now on.
        haste: Simulated seconds in a second of the clock.
        watch: Is told of every step; for measurements.
    """

    def __init__(self, world: World, haste: float, watch: Watch | None = None) -> None:
        self._world = world
        self._haste = haste
        self._watch = watch
        self._lock = threading.RLock()
        self._goal = world.joints
        self._motion: _Motion | None = None
        self._grip_began: float | None = None
        self._grip_seen = (world.time, world.opening)
        self._begun = time.monotonic() - world.time / haste
        self._closing = threading.Event()
        self._thread = threading.Thread(target=self._run, name="physics", daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Let time stand still."""
        self._closing.set()
        self._thread.join()

    def scene(self) -> tuple[Scene, float]:
        """The table as it is now, and when that is by the clock."""
        with self._lock:
            return self._world.scene(), self._now()

    def moment(self) -> TwinMoment:
        """Table, arm and hand as they are now."""
        with self._lock:
            world = self._world
            return TwinMoment(world.scene().objects, world.joints, world.opening, self._now())

    def joints(self) -> tuple[Array, float]:
        """Joint angles, radians, and when they were so by the clock."""
        with self._lock:
            return self._world.joints, self._now()

    def opening(self) -> float:
        """Distance of the pads, metres."""
        with self._lock:
            return self._world.opening

    def start(self, trajectory: Trajectory) -> None:
        """Begin a motion from where the arm is, now by the clock.

        The world may not have got that far; begun at its own time, the arm would be ahead of its
        plan for whoever goes by the clock, and be stopped.
        """
        with self._lock:
            behind = max(0.0, time.monotonic() - self._now()) * self._haste
            self._motion = _Motion(trajectory, self._world.time + behind, self._now())

    def moving(self) -> bool:
        """Whether a motion is under way."""
        with self._lock:
            return self._motion is not None

    def grip(self, opening: float) -> None:
        """Begin to move the pads towards a distance, metres."""
        with self._lock:
            self._world.command_opening(opening)
            self._grip_began = self._world.time
            self._grip_seen = (self._world.time, self._world.opening)

    def gripping(self) -> bool:
        """Whether the pads still move."""
        with self._lock:
            return self._grip_began is not None

    def stop(self) -> None:
        """Hold the arm and the pads where they are."""
        with self._lock:
            self._motion, self._goal = None, self._world.joints
            self._world.command(self._goal, np.zeros_like(self._goal))
            if self._grip_began is not None:
                self._world.command_opening(self._world.opening)
                self._grip_began = None

    def _now(self) -> float:
        """The clock's time that the world has got to."""
        return self._begun + self._world.time / self._haste

    def _run(self) -> None:
        while not self._closing.is_set():
            with self._lock:
                behind = (time.monotonic() - self._now()) * self._haste
                for _ in range(min(_AT_ONCE, int(behind / TIME_STEP))):
                    self._step()
            if behind < _AT_ONCE * TIME_STEP:
                time.sleep(_TICK)

    def _step(self) -> None:
        if self._motion is not None:
            self._command(self._motion)
        self._world.step()
        if self._watch is not None:
            self._watch(self._world.joints, self._world.joint_speeds * self._haste)
        if self._grip_began is not None:
            self._look_at_grip(self._grip_began)

    def _command(self, motion: _Motion) -> None:
        elapsed = max(0.0, self._world.time - motion.began) / self._haste
        joints, velocities = motion.trajectory.at(elapsed)
        self._goal = np.array(joints)
        self._world.command(self._goal, np.array(velocities) / self._haste)
        if elapsed > motion.trajectory.duration + _SETTLE / self._haste:
            self._motion = None

    def _look_at_grip(self, began: float) -> None:
        now = self._world.time
        if now - self._grip_seen[0] < _GRIP_STILL:
            return
        still = abs(self._world.opening - self._grip_seen[1]) < _GRIP_CREEP
        self._grip_seen = (now, self._world.opening)
        if (still and now - began > _GRIP_LEAST) or now - began > _GRIP_MOST:
            self._grip_began = None
