"""Pictures for a film: small, true to the camera, and never in the way of what moves."""

from __future__ import annotations

import threading
import time
from typing import Iterator

import pytest

from bridges import TOKEN, Running, practice, running
from busy import Machine
from probe_bridge.client import RobotClient
from probe_bridge.config import BridgeCamera
from probe_bridge.description import coarser
from probe_bridge.driver import Shot
from probe_bridge.errors import BridgeError
from probe_bridge.replies import glimpsed, thinned


@pytest.fixture
def bridge() -> Iterator[Running]:
    """An arm with a slow wrist: its motions are long, and quickly planned."""
    raw = practice()
    raw["joints"][5]["speed"] = 0.3
    with running(raw) as bridge:
        yield bridge


def turned(client: RobotClient) -> None:
    """A motion of about two seconds."""
    start = client.joints()
    client.follow([start, [*start[:5], start[5] + 0.6]])


@pytest.mark.parametrize("step", [1, 2, 3, 5])
def test_every_so_many_pixels_and_rows_are_kept(step: int):
    width, height = 7, 5
    picture = bytes(range(3 * width * height))
    wanted = [
        value
        for row in range(0, height, step)
        for column in range(0, width, step)
        for value in picture[3 * (width * row + column) :][:3]
    ]
    assert list(thinned(picture, width, height, step)) == wanted


@pytest.mark.parametrize("step", [1, 2, 3])
def test_a_small_picture_s_pixels_look_where_those_that_were_kept_did(step: int):
    camera = BridgeCamera("c", 641, 480, 600.0, 610.0, 322.0, 241.5, (0, 0, 0), (1, 0, 0, 0))
    small = coarser(camera, step)
    assert (small.width, small.height) == (-(-641 // step), -(-480 // step))
    for number in (0, 7, small.width - 1):
        across = (step * number + 0.5 - camera.cx) / camera.fx
        assert (number + 0.5 - small.cx) / small.fx == pytest.approx(across)
    down = (step * 11 + 0.5 - camera.cy) / camera.fy
    assert (11.5 - small.cy) / small.fy == pytest.approx(down)


def test_a_glimpse_is_small_and_says_where_the_arm_was(client: RobotClient):
    seen = client.glimpse("table", 4)
    assert (seen.camera.width, seen.camera.height) == (80, 60)
    assert seen.rgb == bytes((120, 110, 100)) * (80 * 60)
    assert seen.joints == client.joints()
    assert 0.0 <= seen.took < 1.0
    assert abs(seen.stamp - time.monotonic()) < 2.0
    with pytest.raises(BridgeError, match="table, basket"):
        client._ask("glimpse", camera="ceiling", step=1)


def test_a_camera_without_colours_is_named():
    camera = BridgeCamera("grey", 16, 16, 20.0, 20.0, 8.0, 8.0, (0, 0, 0), (1, 0, 0, 0))
    with pytest.raises(BridgeError, match="grey gives no colours"):
        glimpsed(Shot(16, 16, bytes(512), 1e-4, None, 0.0), camera, 1)


def test_a_camera_that_hangs_holds_up_neither_leases_nor_a_stop(
    bridge: Running, machine: Machine, monkeypatch: pytest.MonkeyPatch
):
    client, seen, hangs = RobotClient(bridge.address, TOKEN), bridge.driver.frame, threading.Event()

    def hanging(camera: str, rgb: bool) -> Shot:
        hangs.set()
        time.sleep(2.5)
        return seen(camera, rgb)

    monkeypatch.setattr(bridge.driver, "frame", hanging)
    looking = threading.Thread(target=client.glimpse, args=("table", 2))
    looking.start()
    assert hangs.wait(2.0)
    with pytest.raises(BridgeError) as second:
        client.glimpse("table", 2)
    assert second.value.kind == "busy"
    turned(client)  # takes all its leases
    before = time.monotonic()
    client.stop()
    assert time.monotonic() - before < machine.late
    looking.join()
    client.close()


def test_a_picture_that_doesn_t_come_leaves_the_connection_open(
    bridge: Running, monkeypatch: pytest.MonkeyPatch
):
    monkeypatch.setattr("probe_bridge.client.GLIMPSE_ANSWER", 0.1)
    client, seen = RobotClient(bridge.address, TOKEN), bridge.driver.frame
    slow = lambda camera, rgb: (time.sleep(0.5), seen(camera, rgb))[1]  # noqa: E731
    monkeypatch.setattr(bridge.driver, "frame", slow)
    with pytest.raises(BridgeError) as late:
        client.glimpse("table", 2)
    assert late.value.kind == "late" and client.open
    client.home()
    client.close()
    assert not client.open
