"""The UR's driver on stand-ins for ur_rtde, pyrealsense2 and the gripper's socket."""

from __future__ import annotations

import socket
import threading
import time
from types import SimpleNamespace
from typing import Any, Dict, Iterator, List

import pytest

from bridges import practice
from fake_modules import install, until
from probe_bridge.config import Config
from probe_bridge.config_file import read_config
from probe_bridge.drivers import open_driver
from probe_bridge.planning import plan

OPTIONS = {
    "host": "127.0.0.1",
    "rate": 125,
    "cameras": [{"name": "basket", "serial": "0123", "rate": 30}],
}
CONFIG: Config = read_config(practice(driver=OPTIONS))
PIXELS = 160 * 120


class Gripper:
    """The URCap's socket: one line in, one line out."""

    def __init__(self) -> None:
        self.values = {"STA": 3, "POS": 0, "OBJ": 3, "GTO": 0, "PRE": 0}
        self.lines: List[str] = []
        self.listening = socket.create_server(("127.0.0.1", 0))
        self.thread = threading.Thread(target=self.serve)
        self.thread.start()

    def serve(self) -> None:
        connection, _ = self.listening.accept()
        with connection, connection.makefile("r") as lines:
            for line in lines:
                self.lines.append(line.strip())
                connection.sendall(self.answer(line.split()).encode() + b"\n")

    def answer(self, words: List[str]) -> str:
        if words[0] == "GET":
            return f"{words[1]} {self.values[words[1]]}"
        self.values[words[1]] = int(words[2])
        return "ack"

    def close(self) -> None:
        self.thread.join(5)
        self.listening.close()


class Arm:
    """RTDE's two interfaces; it is at once where servoJ sends it."""

    def __init__(self) -> None:
        self.place = list(CONFIG.home)
        self.targets: List[List[float]] = []
        self.calls: List[str] = []
        self.protective = False

    def servo(self, q: List[float], speed: float, acceleration: float, *rest: float) -> bool:
        period, look_ahead, gain = rest
        assert period == pytest.approx(0.008)
        assert 0.03 <= look_ahead <= 0.2
        assert 100 <= gain <= 2000
        self.targets.append(q)
        self.place = q
        return True

    def control(self, _host: str) -> SimpleNamespace:
        return SimpleNamespace(
            servoJ=self.servo,
            servoStop=lambda rate: self.calls.append(f"servoStop {rate}"),
            stopScript=lambda: self.calls.append("stopScript"),
        )

    def receive(self, _host: str) -> SimpleNamespace:
        return SimpleNamespace(
            getActualQ=lambda: list(self.place),
            isConnected=lambda: True,
            isProtectiveStopped=lambda: self.protective,
            isEmergencyStopped=lambda: False,
        )


def realsense() -> Dict[str, Any]:
    """pyrealsense2 with a camera whose depth is 800 steps of 1 mm."""
    depth = SimpleNamespace(
        get_width=lambda: 160,
        get_height=lambda: 120,
        get_data=lambda: memoryview(b"\x20\x03" * PIXELS),
    )
    colour = SimpleNamespace(get_data=lambda: memoryview(b"\x01\x02\x03" * PIXELS))
    frames = SimpleNamespace(get_depth_frame=lambda: depth, get_color_frame=lambda: colour)
    sensor = SimpleNamespace(get_depth_scale=lambda: 0.001)
    device = SimpleNamespace(first_depth_sensor=lambda: sensor)
    pipeline = SimpleNamespace(
        start=lambda _: SimpleNamespace(get_device=lambda: device),
        wait_for_frames=lambda _: frames,
        stop=lambda: None,
    )
    config = SimpleNamespace(enable_device=lambda _: None, enable_stream=lambda *_: None)
    return {
        "config": lambda: config,
        "pipeline": lambda: pipeline,
        "align": lambda _: SimpleNamespace(process=lambda pictures: pictures),
        "stream": SimpleNamespace(color=1, depth=2),
        "format": SimpleNamespace(rgb8=1, z16=2),
    }


@pytest.fixture
def gripper(monkeypatch: pytest.MonkeyPatch) -> Iterator[Gripper]:
    gripper = Gripper()
    port = gripper.listening.getsockname()[1]
    monkeypatch.setattr("probe_bridge.drivers.robotiq.PORT", port)
    yield gripper
    gripper.close()


@pytest.fixture
def arm(monkeypatch: pytest.MonkeyPatch, gripper: Gripper) -> Arm:
    arm = Arm()
    install(
        monkeypatch,
        {
            "rtde_control": {"RTDEControlInterface": arm.control},
            "rtde_receive": {"RTDEReceiveInterface": arm.receive},
            "pyrealsense2": realsense(),
        },
    )
    return arm


def test_a_motion_is_streamed_in_radians_and_ends_servo_mode(arm: Arm):
    driver = open_driver("ur_rtde", CONFIG)
    assert driver.joints().joints == CONFIG.home
    motion = plan([CONFIG.home, (*CONFIG.home[:5], 0.5)], CONFIG.home, CONFIG)
    driver.start(motion)
    until(driver.poll)
    assert arm.targets[-1] == list(motion.joints[-1])
    lasts = [target[5] for target in arm.targets]
    assert lasts == sorted(lasts)
    assert len(lasts) > 20
    assert arm.calls == ["servoStop 2.0"]
    driver.close()
    assert arm.calls[-1] == "stopScript"


def test_stop_sends_no_further_target(arm: Arm):
    driver = open_driver("ur_rtde", CONFIG)
    driver.start(plan([CONFIG.home, (*CONFIG.home[:5], 1.5)], CONFIG.home, CONFIG))
    time.sleep(0.2)
    driver.stop()
    count = len(arm.targets)
    assert arm.calls == ["servoStop 2.0"]
    time.sleep(0.1)
    assert len(arm.targets) == count
    driver.stop()
    assert arm.calls == ["servoStop 2.0"]
    driver.close()


def test_a_protective_stop_is_an_error(arm: Arm):
    driver = open_driver("ur_rtde", CONFIG)
    driver.start(plan([CONFIG.home, (*CONFIG.home[:5], 1.5)], CONFIG.home, CONFIG))
    arm.protective = True
    with pytest.raises(RuntimeError, match="protective"):
        driver.poll()
    driver.close()


def test_the_gripper_counts_from_open_to_closed(arm: Arm, gripper: Gripper):
    driver = open_driver("ur_rtde", CONFIG)
    assert driver.opening() == CONFIG.max_opening
    driver.start_grip(0.0)
    assert "SET POS 255" in gripper.lines
    assert not driver.poll_grip(), "it has not taken notice of the goal yet"
    gripper.values.update(PRE=255, OBJ=0)
    assert not driver.poll_grip()
    gripper.values.update(OBJ=2, POS=51)  # it holds something
    assert driver.poll_grip()
    assert driver.opening() == pytest.approx(0.8 * CONFIG.max_opening)
    driver.stop()
    assert gripper.lines[-1] == "SET GTO 0"
    driver.close()


def test_a_picture_has_the_sensors_unit(arm: Arm):
    driver = open_driver("ur_rtde", CONFIG)
    shot = driver.frame("basket", rgb=True)
    assert (shot.width, shot.height, shot.depth_unit) == (160, 120, 0.001)
    assert shot.depth == b"\x20\x03" * PIXELS
    assert shot.rgb == b"\x01\x02\x03" * PIXELS
    assert driver.frame("basket", rgb=False).rgb is None
    driver.close()


def test_the_real_package_has_these_methods():
    control = pytest.importorskip("rtde_control").RTDEControlInterface
    receive = pytest.importorskip("rtde_receive").RTDEReceiveInterface
    for name in ("servoJ", "servoStop", "stopScript"):
        assert hasattr(control, name)
    for name in ("getActualQ", "isConnected", "isProtectiveStopped", "isEmergencyStopped"):
        assert hasattr(receive, name)
    assert control.servoJ.__doc__.count("float") >= 6
