"""The Jaco's driver on a stand-in with the messages of kinova-ros: degrees, finger turns."""

from __future__ import annotations

import array
import json
import math
import threading
import time
from types import SimpleNamespace
from typing import Any, Callable, Dict, List

import pytest

from bridges import EXAMPLES
from fake_modules import install, until
from probe_bridge.config import Config
from probe_bridge.config_file import read_config
from probe_bridge.drivers import open_driver
from probe_bridge.errors import BridgeError
from probe_bridge.planning import plan

CONFIG: Config = read_config(json.loads((EXAMPLES / "jaco.json").read_text()))


def message(*names: str) -> Callable[[], SimpleNamespace]:
    return lambda: SimpleNamespace(**dict.fromkeys(names, 0.0))


JointVelocity = JointAngles = message(*(f"joint{i}" for i in range(1, 8)))
FingerPosition = message("finger1", "finger2", "finger3")


class Arm:
    """What kinova-ros does: velocities for 10 ms each, angles at 100 Hz, stop and start."""

    def __init__(self) -> None:
        self.degrees = [math.degrees(angle) for angle in CONFIG.home]
        self.commands: List[List[float]] = []
        self.calls: List[str] = []
        self.enabled = True
        self.callbacks: Dict[str, Callable[[Any], None]] = {}
        self.turns = 0.0
        self.goal_state = 3
        self.ended = threading.Event()
        self.velocity = [0.0] * 6
        self.fresh = 0
        self.thread = threading.Thread(target=self.live)

    def live(self) -> None:
        last = time.monotonic()
        while not self.ended.wait(0.01):
            now = time.monotonic()
            if self.enabled and self.fresh > 0:
                self.degrees = [a + v * (now - last) for a, v in zip(self.degrees, self.velocity)]
                self.fresh -= 1
            last = now
            self.tell()

    def tell(self) -> None:
        angles, fingers = JointAngles(), FingerPosition()
        for i, angle in enumerate(self.degrees):
            setattr(angles, f"joint{i + 1}", angle)
        fingers.finger1 = fingers.finger2 = fingers.finger3 = self.turns
        for topic, value in (("joint_angles", angles), ("finger_position", fingers)):
            if f"/j2s6s300_driver/out/{topic}" in self.callbacks:
                self.callbacks[f"/j2s6s300_driver/out/{topic}"](value)

    def subscribe(
        self, topic: str, _: Any, callback: Callable[[Any], None], queue_size: int
    ) -> None:
        self.callbacks[topic] = callback

    def publisher(self, topic: str, _: Any, queue_size: int) -> SimpleNamespace:
        assert topic == "/j2s6s300_driver/in/joint_velocity"
        return SimpleNamespace(publish=self.command)

    def command(self, velocity: Any) -> None:
        self.velocity = [getattr(velocity, f"joint{i}") for i in range(1, 7)]
        self.commands.append(self.velocity)
        self.fresh = 20

    def service(self, name: str, _: Any) -> Callable[[], None]:
        def call() -> None:
            self.calls.append(name.rsplit("/", 1)[1])
            self.enabled = name.endswith("start")

        return call

    def hand(self, name: str, _: Any) -> SimpleNamespace:
        assert name == "/j2s6s300_driver/fingers_action/finger_positions"
        return SimpleNamespace(
            send_goal=self.close_fingers,
            get_state=lambda: self.goal_state,
            cancel_goal=lambda: self.calls.append("cancel"),
        )

    def close_fingers(self, goal: Any) -> None:
        assert goal.fingers.finger1 == goal.fingers.finger2 == goal.fingers.finger3
        self.turns = goal.fingers.finger1


@pytest.fixture
def arm(monkeypatch: pytest.MonkeyPatch):
    arm = Arm()
    rospy = {
        "init_node": lambda *_, **__: None,
        "Subscriber": arm.subscribe,
        "Publisher": arm.publisher,
        "ServiceProxy": arm.service,
        "signal_shutdown": lambda _: None,
    }
    messages = {
        "JointAngles": JointAngles,
        "JointVelocity": JointVelocity,
        "FingerPosition": FingerPosition,
        "SetFingersPositionAction": object,
        "SetFingersPositionGoal": lambda: SimpleNamespace(fingers=FingerPosition()),
    }
    install(
        monkeypatch,
        {
            "rospy": rospy,
            "actionlib": {"SimpleActionClient": arm.hand},
            "sensor_msgs.msg": {"Image": object},
            "kinova_msgs.msg": messages,
            "kinova_msgs.srv": {"Stop": object, "Start": object},
        },
    )
    arm.thread.start()
    yield arm
    arm.ended.set()
    arm.thread.join()


def moved(joint: int, change: float) -> Any:
    goal = list(CONFIG.home)
    goal[joint] += change
    return plan([CONFIG.home, tuple(goal)], CONFIG.home, CONFIG)


def test_degrees_become_radians_in_order(arm: Arm):
    driver = open_driver("kinova_ros", CONFIG)
    reading = driver.joints()
    assert reading.joints == pytest.approx(CONFIG.home)
    assert abs(reading.stamp - time.monotonic()) < 0.5
    driver.close()


def test_a_motion_is_sent_as_degrees_a_second_and_arrives(arm: Arm):
    driver = open_driver("kinova_ros", CONFIG)
    motion = moved(5, 0.4)
    driver.start(motion)
    until(driver.poll)
    assert driver.joints().joints == pytest.approx(motion.joints[-1], abs=0.02)
    fastest = [max(abs(row[i]) for row in arm.commands) for i in range(6)]
    assert math.degrees(0.2) < fastest[5] <= math.degrees(0.8) + 1e-9
    assert max(fastest[:5]) < math.degrees(0.05)
    assert arm.commands[-1] == [0.0] * 6
    driver.close()


def test_stop_sends_zero_and_disables_and_the_next_start_enables(arm: Arm):
    driver = open_driver("kinova_ros", CONFIG)
    driver.start(moved(5, 1.0))
    time.sleep(0.3)
    driver.stop()
    assert arm.commands[-1] == [0.0] * 6
    assert arm.calls == ["stop"]
    count = len(arm.commands)
    time.sleep(0.1)
    assert len(arm.commands) == count
    measured = driver.joints().joints
    driver.start(plan([measured], measured, CONFIG))
    assert arm.calls == ["stop", "start"]
    driver.close()


def test_the_hand_moves_in_turns(arm: Arm):
    driver = open_driver("kinova_ros", CONFIG)
    until(lambda: driver.opening() == pytest.approx(0.10))
    driver.start_grip(0.025)
    assert arm.turns == pytest.approx(4800)
    until(lambda: driver.opening() == pytest.approx(0.025))
    arm.goal_state = 1
    assert not driver.poll_grip()
    arm.goal_state = 2  # so kinova-ros calls a hand that holds something
    assert driver.poll_grip()
    arm.goal_state = 4
    with pytest.raises(RuntimeError, match="state 4"):
        driver.poll_grip()
    driver.stop()
    assert arm.calls == ["stop", "cancel"]
    driver.close()


def test_pictures_are_those_that_come_after_the_question(arm: Arm):
    driver = open_driver("kinova_ros", CONFIG)
    colour = SimpleNamespace(
        width=2, height=1, encoding="rgb8", step=6, is_bigendian=0, data=bytes(range(6))
    )
    depth = SimpleNamespace(
        width=2,
        height=1,
        encoding="16UC1",
        step=4,
        is_bigendian=0,
        data=array.array("H", [500, 0]).tobytes(),
    )
    ended = threading.Event()

    def publish() -> None:
        while not ended.wait(0.02):
            arm.callbacks["/camera/color/image_raw"](colour)
            arm.callbacks["/camera/aligned_depth_to_color/image_raw"](depth)

    camera = threading.Thread(target=publish)
    camera.start()
    asked = time.monotonic()
    shot = driver.frame("front", rgb=True)
    ended.set()
    camera.join()
    assert shot.stamp > asked
    assert (shot.rgb, shot.depth_unit) == (bytes(range(6)), 0.001)
    driver.close()


def test_without_ros_the_error_says_what_to_do():
    with pytest.raises(BridgeError, match=r"rospy.*Source the workspace"):
        open_driver("kinova_ros", CONFIG)
