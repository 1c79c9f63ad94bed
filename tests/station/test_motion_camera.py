"""Pictures of a moving arm: enough of them, whole, and never at the arm's cost."""

from __future__ import annotations

import random
import socket
import threading
import time
from collections.abc import Generator
from contextlib import closing, contextmanager, suppress
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from bridges import TOKEN, Running, running

from probe.errors import OutputFailed
from probe.scene.setup import UR5_TABLE
from probe.station.motion_camera import RATE, MotionPicture
from probe.station.remote import RobotStation, connected
from probe.twin.config import twin_config

PARKED = np.array(UR5_TABLE.mount.parked)
WHOLE: dict[str, Any] = {**twin_config(UR5_TABLE), "driver": {"distance": 0.9}}
SLOW = {**WHOLE, "joints": [{**joint, "speed": 0.3} for joint in WHOLE["joints"]]}
AWAY = PARKED + (0, 0, 0, 0, 0, 0.6)


@contextmanager
def station(bridge: Running, address: str | None = None) -> Generator[RobotStation]:
    with closing(connected(address or bridge.address, TOKEN)) as client:
        yield RobotStation(client, UR5_TABLE, looks=1)


@contextmanager
def throttled(address: str, rate: int) -> Generator[str]:
    """A way to a bridge over which so many bytes a second come back, as over a slow radio link."""
    listener = socket.create_server(("127.0.0.1", 0))
    port = int(address.rpartition(":")[2])

    def passing(here: socket.socket, there: socket.socket, pace: float) -> None:
        with here, there, suppress(OSError):
            while data := here.recv(8192):
                time.sleep(len(data) * pace)
                there.sendall(data)

    def serve() -> None:
        client, _ = listener.accept()
        bridge = socket.socket()
        bridge.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 8192)
        bridge.connect(("127.0.0.1", port))
        threading.Thread(target=passing, args=(client, bridge, 0.0), daemon=True).start()
        threading.Thread(target=passing, args=(bridge, client, 1 / rate), daemon=True).start()

    threading.Thread(target=serve, daemon=True).start()
    yield f"ws://127.0.0.1:{listener.getsockname()[1]}"
    listener.close()


def test_a_motion_is_seen_several_times_a_second() -> None:
    kept: list[MotionPicture] = []
    with running(SLOW) as bridge, station(bridge) as robot:
        robot.film(kept.append)
        began = time.monotonic()
        assert robot.follow(np.array([AWAY]))
        seconds = time.monotonic() - began
        count = len(kept)
        time.sleep(1.0)
        # At rest there is nothing to see; one may have been on its way.
        assert len(kept) <= count + 1
    assert 0.4 * RATE * seconds < count <= RATE * seconds + 2
    stamps = [each.stamp for each in kept]
    assert stamps == sorted(stamps) and len(set(stamps)) == len(stamps)
    moved = [each.moved for each in kept]
    assert moved == sorted(moved) and moved[0] >= 0 and moved[-1] <= seconds
    wrist = [each.joints[5] for each in kept]
    assert wrist == sorted(wrist) and wrist[-1] > wrist[0] + 0.2
    assert {each.rgb.shape for each in kept} == {(512, 512, 3)}
    assert all((each.rgb == (120, 110, 100)).all() for each in kept)


@pytest.mark.slow
def test_over_a_slow_link_pictures_shrink_and_the_arm_arrives(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A megabyte a second: whole pictures would hold up the answers to leases for a second."""
    kept: list[MotionPicture] = []
    with running(SLOW) as bridge, throttled(bridge.address, 10**6) as slow:
        seen, noise = bridge.driver.frame, random.Random(1).randbytes(3 * 1024 * 1024)
        grainy = lambda *about: seen(*about)._replace(rgb=noise)  # noqa: E731
        monkeypatch.setattr(bridge.driver, "frame", grainy)
        with station(bridge, slow) as robot:
            robot.film(kept.append)
            time.sleep(1.5)
            assert robot.follow(np.array([AWAY])) and robot.follow(np.array([PARKED]))
    assert len(kept) > 3
    assert all(len(each.rgb) < 300 for each in kept)


def test_a_camera_that_fails_costs_pictures_and_no_episode(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    kept: list[MotionPicture] = []
    with running(SLOW) as bridge:
        log = tmp_path / "commands.jsonl"
        with closing(connected(bridge.address, TOKEN, log=log)) as client:
            robot = RobotStation(client, UR5_TABLE, looks=1)
            monkeypatch.setattr(bridge.driver, "frame", lambda *about: 1 / 0)
            robot.film(kept.append)
            assert robot.follow(np.array([AWAY]))
    assert not kept
    assert "not filmed" in log.read_text() and "ZeroDivisionError" in log.read_text()


def test_a_full_disk_is_told_before_the_next_motion() -> None:
    def full(seen: MotionPicture) -> None:
        raise OutputFailed("frames", OSError(28, "No space left on device"))

    with running(SLOW) as bridge, station(bridge) as robot:
        robot.film(full)
        assert robot.follow(np.array([AWAY]))
        with pytest.raises(OutputFailed, match="No space left"):
            robot.follow(np.array([PARKED]))
        assert len(bridge.driver.moves) == 1
