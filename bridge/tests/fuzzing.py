"""Commands for a bridge, half of them sensible and half of them spoilt."""

from __future__ import annotations

import random
import time
from typing import Any, Dict, List

from websockets.exceptions import ConnectionClosed
from websockets.sync.client import ClientConnection

from probe_bridge.driver import Driver
from probe_bridge.robot import Robot
from probe_bridge.wire import VERSION, pack, unpack_reply
from raw import HELLO, ask

ODD = [float("nan"), float("inf"), -float("inf"), 1e300, 2**63, -1, 0, True, None, "1", b"", [], {}]


def near(rng: random.Random, driver: Driver) -> List[List[float]]:
    """A path that begins where the arm is; its steps may go anywhere."""
    row = list(driver.joints().joints)
    rows = [list(row)]
    for _ in range(rng.randint(1, 4)):
        scale = rng.choice([0.01, 0.03, 0.1, 0.3, 1.0])
        row = [angle + rng.uniform(-scale, scale) for angle in row]
        rows.append(row)
    return rows


def command(rng: random.Random, driver: Driver) -> Dict[str, Any]:
    """A command that may be sensible."""
    kinds = ["follow"] * 12 + [
        "home",
        "grip",
        "stop",
        "joints",
        "state",
        "wait",
        "observe",
        "glimpse",
        "hello",
    ]
    do = rng.choice(kinds)
    arguments: Dict[str, Any] = {
        "follow": {"path": near(rng, driver), "speed": rng.uniform(0.5, 1.02)},
        "home": {"speed": 1.0},
        "grip": {"opening": rng.uniform(0.11, 0.14)},
        "wait": {"seconds": rng.uniform(-0.01, 0.01)},
        "observe": {"camera": rng.choice(["basket", "?"]), "rgb": rng.random() < 0.5},
        "glimpse": {"camera": "basket", "step": rng.randint(0, 17)},
        "hello": {"version": rng.choice([VERSION, VERSION, VERSION, -3])},
    }.get(do, {})
    seen = {"seen": time.monotonic() - rng.choice([0.0, 0.0, 0.0, 9.0, -9.0])}
    return {"do": do, **arguments, **(seen if do in ("follow", "home", "grip") else {})}


def spoilt(rng: random.Random, message: Dict[str, Any]) -> Dict[str, Any]:
    """The same command with something odd in it."""
    if message["do"] == "follow" and rng.random() < 0.7:
        path = message["path"]
        row = rng.choice(path)
        row[rng.randrange(6)] = rng.choice([*ODD, rng.uniform(-50, 50)])
        if rng.random() < 0.3:
            row.append(0.0)
        return message
    return {**message, rng.choice([*message, "seq", "x"]): rng.choice(ODD)}


def spoilt_bytes(rng: random.Random, message: Dict[str, Any]) -> bytes:
    """A command with something wrong in it, or in its bytes."""
    if rng.random() < 0.8:
        return pack(spoilt(rng, message))
    data = bytearray(pack(message))
    data[rng.randrange(len(data))] ^= 1 << rng.randrange(8)
    return bytes(data)


def fuzz(socket: ClientConnection, robot: Robot, rng: random.Random, count: int) -> int:
    """Send commands until the bridge ends the connection; returns how many were sent."""
    ask(socket, HELLO)
    for seq in range(2, count + 2):
        # Sometimes the next command comes into the middle of a motion.
        while robot._mover.busy and rng.random() < 0.98:
            time.sleep(0.005)
        message = {"seq": seq, **command(rng, robot._driver)}
        try:
            spoil = rng.random() < 0.5
            socket.send(spoilt_bytes(rng, message) if spoil else pack(message))
            unpack_reply(socket.recv(5))
        except ConnectionClosed:
            return seq - 1
    return count
