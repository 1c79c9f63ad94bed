"""Universal Robots' arms over RTDE (package ur_rtde 1.6), a Robotiq hand, RealSense cameras.

Never tried on hardware, nor on UR's simulator. Motions are streamed with servoJ, which runs behind
its targets by its look-ahead time: the config's "delay" must be above 0.15. If this process
dies, no further target comes and the arm stays where it is; that too was not tried. The
controller's own safety limits count in any case: set them on the pendant.

Options: "host" (the controller), "rate" (targets a second: 500 on e-Series, 125 on CB3),
"cameras": a list of {"name", "serial", "rate"}.
"""

from __future__ import annotations

import threading
import time
from typing import Any, Dict, Optional

from probe_bridge.config import Config
from probe_bridge.driver import Reading, Shot
from probe_bridge.drivers import library
from probe_bridge.drivers.realsense import RealSense
from probe_bridge.drivers.robotiq import Robotiq
from probe_bridge.drivers.streaming import Stream
from probe_bridge.fields import Fields
from probe_bridge.trajectory import Trajectory

_REMEDY = "pip install ur-rtde"
_LOOK_AHEAD = 0.1
_SERVO_GAIN = 300
_SETTLE = 0.3
_DECELERATION = 2.0
"""Radians a second squared of the leading joint, when the arm is stopped."""


class UrDriver:
    """A UR with everything that belongs to it. Joints are in the controller's order, radians."""

    def __init__(self, config: Config) -> None:
        options = Fields(config.options, "config.driver")
        host = options.text("host")
        self._period = 1.0 / options.whole("rate", 50, 500)
        devices = [
            (camera.text("name"), camera.text("serial"), camera.whole("rate", 1, 90))
            for camera in options.each("cameras")
        ]
        options.end()
        receive: Any = library("rtde_receive", _REMEDY)
        control: Any = library("rtde_control", _REMEDY)
        self._receive = receive.RTDEReceiveInterface(host)
        self._control = control.RTDEControlInterface(host)
        self._hand = Robotiq(host, config.max_opening)
        self._cameras: Dict[str, RealSense] = {
            name: RealSense(config.cameras[name], serial, rate) for name, serial, rate in devices
        }
        self._lock = threading.Lock()
        self._stream: Optional[Stream] = None

    def joints(self) -> Reading:
        """The time is the call's: RTDE sends angles at its rate, or fails."""
        if not self._receive.isConnected():
            raise ConnectionError("the controller sends nothing any more")
        angles = self._receive.getActualQ()
        return Reading(tuple(float(angle) for angle in angles), time.monotonic())

    def opening(self) -> float:
        return self._hand.opening()

    def frame(self, camera: str, rgb: bool) -> Shot:
        return self._cameras[camera].frame(rgb)

    def start(self, trajectory: Trajectory) -> None:
        self._check_safety()

        def send(seconds: float) -> bool:
            target = list(trajectory.at(seconds)[0])
            if not self._control.servoJ(target, 0.0, 0.0, self._period, _LOOK_AHEAD, _SERVO_GAIN):
                raise RuntimeError("the controller refuses a target")
            return seconds > trajectory.duration + _SETTLE

        with self._lock:
            self._stream = Stream(self._period, send)

    def poll(self) -> bool:
        self._check_safety()
        if self._stream is None or not self._stream.done():
            return self._stream is None
        self._halt()
        return True

    def start_grip(self, opening: float) -> None:
        self._check_safety()
        self._hand.start(opening)

    def poll_grip(self) -> bool:
        return self._hand.resting()

    def stop(self) -> None:
        self._halt()
        self._hand.stop()

    def close(self) -> None:
        self.stop()
        self._control.stopScript()
        for camera in self._cameras.values():
            camera.close()
        self._hand.close()

    def _halt(self) -> None:
        """End servo mode, once: the control interface is not for two threads at a time."""
        with self._lock:
            if self._stream:
                self._stream.stop()
                self._control.servoStop(_DECELERATION)
                self._stream = None

    def _check_safety(self) -> None:
        if self._receive.isProtectiveStopped() or self._receive.isEmergencyStopped():
            raise RuntimeError("the arm is in a protective or emergency stop")
