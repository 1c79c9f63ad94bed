"""A bridge that listens in a thread, with a simulated arm that remembers what it did."""

from __future__ import annotations

import asyncio
import json
import threading
import time
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Dict, Generator, List, NamedTuple, Optional, Tuple

from probe_bridge.command_log import CommandLog
from probe_bridge.config import Config
from probe_bridge.config_file import read_config
from probe_bridge.drivers.simulated import SimulatedDriver
from probe_bridge.robot import Robot
from probe_bridge.server import Address, listen
from probe_bridge.trajectory import Trajectory

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"
TOKEN = "a-token-that-is-long-enough"
ANY_PORT = Address(port=0)


class Executed(NamedTuple):
    """A motion and for how much of it, in seconds, the arm carried it out."""

    trajectory: Trajectory
    seconds: float


class RememberingDriver(SimulatedDriver):
    """The simulated driver; it keeps what was really moved, and when it was stopped."""

    def __init__(self, config: Config) -> None:
        super().__init__(config)
        self.executed: List[Executed] = []
        self.moves: List[Tuple[Trajectory, float]] = []
        self.stops: List[float] = []

    def start(self, trajectory: Trajectory) -> None:
        self.moves.append((trajectory, time.monotonic()))
        super().start(trajectory)

    def stop(self) -> None:
        super().stop()
        self.stops.append(time.monotonic())

    def _settle(self, now: float) -> None:
        if self._motion:
            trajectory, started = self._motion
            self.executed.append(Executed(trajectory, min(now - started, trajectory.duration)))
        super()._settle(now)


def practice(**changes: Any) -> Dict[str, Any]:
    """The practice arm's file, with some fields changed."""
    raw = json.loads((EXAMPLES / "simulated.json").read_text())
    return {**raw, **changes}


def quick(factor: float) -> Dict[str, Any]:
    """The practice arm, with all speeds multiplied, so that tests are short."""
    raw = practice()
    for joint in raw["joints"]:
        joint["speed"] *= factor
        joint["acceleration"] *= factor**2
    return {**raw, "tool_speed": 10.0}


class Running(NamedTuple):
    """A bridge that listens."""

    address: str
    driver: RememberingDriver
    robot: Robot
    host: str


@contextmanager
def running(
    raw: Dict[str, Any], address: Address = ANY_PORT, log: Optional[CommandLog] = None
) -> Generator[Running, None, None]:
    """A bridge in a thread of its own, for as long as the block lasts."""
    config = read_config(raw)
    driver = RememberingDriver(config)
    robot = Robot(driver, config)
    loop = asyncio.new_event_loop()
    server = loop.run_until_complete(listen(robot, TOKEN, address, log))
    host, port = server.sockets[0].getsockname()[:2]
    thread = threading.Thread(target=loop.run_forever)
    thread.start()
    try:
        scheme = "wss" if address.tls else "ws"
        yield Running(f"{scheme}://{host}:{port}", driver, robot, host)
    finally:
        asyncio.run_coroutine_threadsafe(_closed(server), loop).result(10)
        robot.close()
        loop.call_soon_threadsafe(loop.stop)
        thread.join()
        loop.close()


async def _closed(server: Any) -> None:
    server.close()
    await server.wait_closed()
    others = asyncio.all_tasks() - {asyncio.current_task()}
    for task in others:
        task.cancel()
    await asyncio.gather(*others, return_exceptions=True)
