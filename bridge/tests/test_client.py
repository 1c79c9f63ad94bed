"""Everything that a client can ask for, over a real connection."""

from __future__ import annotations

import struct
import threading
import time

import pytest

from bridges import TOKEN, Running
from probe_bridge.client import RobotClient
from probe_bridge.errors import BridgeError


def test_hello_describes_the_robot(client: RobotClient):
    robot = client.description
    assert robot.model == "UR5"
    assert [joint.name for joint in robot.joints][:2] == [
        "shoulder_pan_joint",
        "shoulder_lift_joint",
    ]
    assert robot.joints[2].upper == 2.8
    assert list(robot.cameras) == ["table", "basket"]
    assert robot.cameras["table"].wxyz == (0, 1, 0, 0)
    assert robot.max_opening == 0.1285
    assert abs(robot.clock - time.monotonic()) < 5


def test_pictures_come_with_depth_and_with_colour_if_asked(client: RobotClient):
    picture = client.observe("table", rgb=True)
    assert picture.rgb is not None
    assert len(picture.rgb) == 320 * 240 * 3
    depths = struct.unpack(f"<{320 * 240}H", picture.depth)
    assert set(depths) == {10000}
    assert depths[0] * picture.depth_unit == pytest.approx(1.0)
    assert picture.camera == client.description.cameras["table"]
    assert client.observe("basket", rgb=False).rgb is None


def test_unknown_camera(client: RobotClient):
    with pytest.raises(BridgeError, match="table, basket"):
        client.observe("ceiling", rgb=False)


def test_a_motion_arrives(client: RobotClient, bridge: Running):
    start = client.joints()
    goal = [start[0] - 0.2, *start[1:5], 0.3]
    reached = client.follow([start, goal])
    assert reached == pytest.approx(goal)
    assert client.joints() == pytest.approx(goal)
    assert client.home() == pytest.approx(client.description.home)
    assert len(bridge.driver.executed) == 2


def test_the_hand(client: RobotClient):
    assert client.grip(0.09) == pytest.approx(0.09)
    assert client.state()["opening"] == pytest.approx(0.09)
    with pytest.raises(BridgeError, match="opens"):
        client.grip(0.5)


def test_state_and_wait(client: RobotClient):
    client.wait(0.05)
    state = client.state()
    assert state["moving"] is False
    assert state["lease_left"] == 0
    assert state["joints"] == list(client.joints())


def test_pictures_and_state_come_during_a_motion(client: RobotClient):
    start = client.joints()
    motion = threading.Thread(target=client.follow, args=([start, [start[0] - 0.6, *start[1:]]],))
    motion.start()
    time.sleep(0.2)
    assert client.state()["moving"] is True
    client.observe("table", rgb=True)
    with pytest.raises(BridgeError) as busy:
        client.grip(0.01)
    assert busy.value.kind == "busy"
    motion.join()
    assert client.state()["moving"] is False


def test_a_wrong_port_is_lost_and_a_wrong_address_says_so():
    with pytest.raises(BridgeError) as lost:
        RobotClient("ws://127.0.0.1:9", TOKEN)
    assert lost.value.kind == "lost"
    with pytest.raises(BridgeError, match="ws://HOST:PORT"):
        RobotClient("robot", TOKEN)
