"""Faults planted in a robot that is well: in its driver, its figures or what its bridge answers."""

from __future__ import annotations

import asyncio
import math
import random
import time
from dataclasses import replace
from typing import Any, Callable, Dict, List

from probe_bridge.config import BridgeCamera
from probe_bridge.curve import Row
from probe_bridge.driver import Driver, Reading, Shot
from probe_bridge.geometry import Transform, about, apply
from probe_bridge.requests import Hello, Request
from probe_bridge.robot import Robot
from probe_bridge.trajectory import Trajectory


class FaultyDriver:
    """A driver that does as another does, until a fault is planted in one of its methods."""

    def __init__(self, driver: Driver) -> None:
        self.well = driver

    def joints(self) -> Reading:
        return self.well.joints()

    def opening(self) -> float:
        return self.well.opening()

    def frame(self, camera: str, rgb: bool) -> Shot:
        return self.well.frame(camera, rgb)

    def start(self, trajectory: Trajectory) -> None:
        self.well.start(trajectory)

    def poll(self) -> bool:
        return self.well.poll()

    def start_grip(self, opening: float) -> None:
        self.well.start_grip(opening)

    def poll_grip(self) -> bool:
        return self.well.poll_grip()

    def stop(self) -> None:
        self.well.stop()

    def close(self) -> None:
        self.well.close()


class Millimetres(FaultyDriver):
    def frame(self, camera: str, rgb: bool) -> Shot:
        shot = self.well.frame(camera, rgb)
        return shot._replace(depth_unit=1000 * shot.depth_unit)


class Mirrored(FaultyDriver):
    def frame(self, camera: str, rgb: bool) -> Shot:
        shot = self.well.frame(camera, rgb)
        depth = _rows_reversed(shot.depth, shot.width, 2)
        return shot._replace(depth=depth, rgb=shot.rgb and _rows_reversed(shot.rgb, shot.width, 3))


class Stale(FaultyDriver):
    """Gives pictures that are some seconds old, or, if it also lies, says that they are new."""

    def __init__(self, driver: Driver, age: float, lies: bool) -> None:
        super().__init__(driver)
        self._age, self._lies = age, lies
        self._kept: Dict[str, List[Shot]] = {}

    def frame(self, camera: str, rgb: bool) -> Shot:
        kept = self._kept.setdefault(camera, [])
        if not self._lies or not kept:
            kept.append(self.well.frame(camera, rgb))
        now = time.monotonic()
        if self._lies:
            return kept[0]._replace(stamp=now)
        old = [shot for shot in kept if shot.stamp < now - self._age]
        return old[-1] if old else kept[0]._replace(stamp=now - self._age)


class Inverted(FaultyDriver):
    def __init__(self, driver: Driver, most: float) -> None:
        super().__init__(driver)
        self._most = most

    def start_grip(self, opening: float) -> None:
        self.well.start_grip(self._most - opening)


class Unstoppable(FaultyDriver):
    def stop(self) -> None:
        pass


class Swapped(FaultyDriver):
    """Two joints get each other's motions."""

    def __init__(self, driver: Driver, one: int, other: int) -> None:
        super().__init__(driver)
        self._pair = one, other

    def start(self, trajectory: Trajectory) -> None:
        begins, start = self.well.joints().joints, trajectory.joints[0]
        joints = tuple(
            tuple(a + b - c for a, b, c in zip(begins, self._mixed(row), self._mixed(start)))
            for row in trajectory.joints
        )
        velocities = tuple(self._mixed(row) for row in trajectory.velocities)
        self.well.start(Trajectory(trajectory.times, joints, velocities))

    def _mixed(self, row: Row) -> Row:
        one, other = self._pair
        mixed = list(row)
        mixed[one], mixed[other] = row[other], row[one]
        return tuple(mixed)


def plant(robot: Robot, fault: str, seed: int) -> None:
    """Plant a fault in a robot; the seed decides how large it is and which side it is on."""
    PLANTS[fault](robot, random.Random(f"{fault} {seed}"))


def _drive(robot: Robot, make: Callable[[Driver], FaultyDriver]) -> None:
    parts: List[Any] = [robot, robot._mover]
    driver = make(robot._driver)
    for part in parts:
        part._driver = driver


def _stale(robot: Robot, chance: random.Random) -> None:
    age, lies = chance.uniform(0.4, 2.0), chance.random() < 0.5
    _drive(robot, lambda driver: Stale(driver, age, lies))


def _swapped(robot: Robot, chance: random.Random) -> None:
    one, other = chance.sample(range(len(robot.config.chain.joints)), 2)
    _drive(robot, lambda driver: Swapped(driver, one, other))


def _see(robot: Robot, change: Callable[[BridgeCamera], BridgeCamera]) -> None:
    cameras = {name: change(camera) for name, camera in robot.config.cameras.items()}
    robot.config = replace(robot.config, cameras=cameras)


def _wrong_intrinsics(robot: Robot, chance: random.Random) -> None:
    by = 1 + chance.choice((-1, 1)) * chance.uniform(0.05, 0.2)
    _see(robot, lambda camera: replace(camera, fx=camera.fx * by, fy=camera.fy * by))


def _base_rotated(robot: Robot, chance: random.Random) -> None:
    """The cameras are told in a world that is turned about the arm's base."""
    angle, (x, y, _) = chance.choice((-1, 1)) * math.pi / 2, robot.config.chain.mount.position
    turn = about((0.0, 0.0, 1.0), angle)

    def change(camera: BridgeCamera) -> BridgeCamera:
        px, py, pz = camera.position
        qx, qy, qz = apply(Transform(turn, (0.0, 0.0, 0.0)), (px - x, py - y, pz))
        a, b, c, d = camera.wxyz
        w, z = math.cos(angle / 2), math.sin(angle / 2)
        wxyz = (w * a - z * d, w * b - z * c, w * c + z * b, w * d + z * a)
        return replace(camera, position=(qx + x, qy + y, qz), wxyz=wxyz)

    _see(robot, change)


def _another_version(robot: Robot, chance: random.Random) -> None:
    answer, off = robot.answer, chance.choice((-1, 1, 2))

    async def answering(request: Request) -> Dict[str, Any]:
        another = Hello(request.version + off) if isinstance(request, Hello) else request
        return await answer(another)

    _answering(robot, answering)


def _clock_jump(robot: Robot, chance: random.Random) -> None:
    """The robot's clock is put on or back once, after some answers."""
    answer, calls = robot.answer, [0]
    after = chance.randrange(20, 345)
    jump = chance.choice((-1, 1)) * math.exp(chance.uniform(math.log(0.1), math.log(100.0)))

    async def answering(request: Request) -> Dict[str, Any]:
        result = await answer(request)
        calls[0] += 1
        by = jump if calls[0] > after else 0.0
        return {k: v + by if k in ("clock", "stamp") else v for k, v in result.items()}

    _answering(robot, answering)


def _dropped(robot: Robot, chance: random.Random) -> None:
    answer, share = robot.answer, chance.uniform(0.02, 0.1)

    async def answering(request: Request) -> Dict[str, Any]:
        if chance.random() < share:
            await asyncio.sleep(3600.0)
        return await answer(request)

    _answering(robot, answering)


def _answering(robot: Robot, answer: Callable[[Request], Any]) -> None:
    changed: Any = robot
    changed.answer = answer


def _rows_reversed(data: bytes, width: int, size: int) -> bytes:
    row = width * size
    rows = [data[k : k + row] for k in range(0, len(data), row)]
    return b"".join(
        b"".join(one[k : k + size] for k in range(row - size, -1, -size)) for one in rows
    )


PLANTS: Dict[str, Callable[[Robot, random.Random], None]] = {
    "depth in millimetres": lambda robot, _: _drive(robot, Millimetres),
    "mirrored picture": lambda robot, _: _drive(robot, Mirrored),
    "stale frames": _stale,
    "gripper inverted": lambda robot, _: _drive(
        robot, lambda driver: Inverted(driver, robot.config.max_opening)
    ),
    "no stop": lambda robot, _: _drive(robot, Unstoppable),
    "swapped axes": _swapped,
    "wrong intrinsics": _wrong_intrinsics,
    "base rotated": _base_rotated,
    "wrong version": _another_version,
    "clock jump": _clock_jump,
    "silent drop of messages": _dropped,
}
"""All faults but a bad token, which is the client's: by the names that the checks give them."""
