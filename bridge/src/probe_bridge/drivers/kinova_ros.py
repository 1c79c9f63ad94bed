"""Kinova's Jaco over kinova-ros (ROS 1), as of its release 1.2.1. Never tried on hardware.

What was read in the source of kinova-ros, and why it is driven by velocities:

- Its trajectory action sends each point's velocity until the point's time is over, without
  looking at positions, and ends with the last velocity that isn't zero. Its joint angle action
  reaches each goal at a speed of its own. Neither keeps to a plan.
- ``in/joint_velocity`` takes degrees a second and must come at 100 Hz. The arm stops when nothing
  comes, so it also stops when this process dies.

Never verified: how well the arm keeps to a plan with _GAIN, and how far it rolls on when it is
stopped. Angles come at 10 Hz only (``status_interval_seconds`` of the driver; 0.02 is better), so
the config's "trail" and "delay" must be wider than for other arms.

Options: "prefix" (the robot's type, such as j2s6s300), "closed_turns" (finger turns of a closed
hand, 6400 or so), "cameras": a list of {"name", "rgb", "depth"} with the topics' names.
"""

from __future__ import annotations

import math
import threading
import time
from typing import Any, Dict, Optional

from probe_bridge.config import Config
from probe_bridge.curve import Row
from probe_bridge.driver import Reading, Shot
from probe_bridge.drivers import library
from probe_bridge.drivers.newest import Newest
from probe_bridge.drivers.ros_images import shot_of
from probe_bridge.drivers.streaming import Stream
from probe_bridge.fields import Fields
from probe_bridge.trajectory import Trajectory

_PERIOD = 0.01
_GAIN = 1.0
"""Share of a joint's distance from its plan that is made good in a second."""

_NEAR = math.radians(0.5)
_SETTLE = 2.0
_REMEDY = "Source the workspace of ROS 1 in which kinova-ros was built."
_RESTING = (2, 3, 8)
"""actionlib's PREEMPTED, SUCCEEDED, RECALLED. kinova-ros says PREEMPTED of a hand that holds."""

_FAILED = (4, 5, 9)
"""ABORTED, REJECTED, LOST."""


class KinovaDriver:
    """A Jaco or Mico with its fingers and any cameras that publish images."""

    def __init__(self, config: Config) -> None:
        options = Fields(config.options, "config.driver")
        self._prefix = options.text("prefix")
        self._closed = options.number("closed_turns", 100.0, 20000.0)
        self._config = config
        self._ros = library("rospy", _REMEDY)
        self._messages = library("kinova_msgs.msg", _REMEDY)
        self._services = library("kinova_msgs.srv", _REMEDY)
        self._ros.init_node("probe_bridge", anonymous=True, disable_signals=True)
        self._cameras: Dict[str, Dict[str, Newest]] = {
            camera.text("name"): {
                kind: self._listen(camera.text(kind), library("sensor_msgs.msg", _REMEDY).Image)
                for kind in ("rgb", "depth")
            }
            for camera in options.each("cameras")
        }
        options.end()
        self._connect()

    def _connect(self) -> None:
        names, types = f"/{self._prefix}_driver", self._messages
        self._angles = self._listen(f"{names}/out/joint_angles", types.JointAngles)
        self._fingers = self._listen(f"{names}/out/finger_position", types.FingerPosition)
        self._speeds = self._ros.Publisher(
            f"{names}/in/joint_velocity", types.JointVelocity, queue_size=1
        )
        self._stop_service = self._ros.ServiceProxy(f"{names}/in/stop", self._services.Stop)
        self._start_service = self._ros.ServiceProxy(f"{names}/in/start", self._services.Start)
        self._hand = library("actionlib", _REMEDY).SimpleActionClient(
            f"{names}/fingers_action/finger_positions", types.SetFingersPositionAction
        )
        self._lock = threading.Lock()
        self._stream: Optional[Stream] = None
        self._gripping = False
        self._stopped = False

    def _listen(self, topic: str, message: Any) -> Newest:
        newest = Newest(topic)
        self._ros.Subscriber(topic, message, newest.put, queue_size=1)
        return newest

    def joints(self) -> Reading:
        message, stamp = self._angles.get()
        count = len(self._config.chain.joints)
        degrees = (getattr(message, f"joint{i + 1}") for i in range(count))
        return Reading(tuple(math.radians(float(angle)) for angle in degrees), stamp)

    def opening(self) -> float:
        """From the mean of the fingers' turns: 0 is open."""
        message, _ = self._fingers.get()
        turns = (message.finger1 + message.finger2) / 2
        return self._config.max_opening * min(1.0, max(0.0, 1.0 - turns / self._closed))

    def frame(self, camera: str, rgb: bool) -> Shot:
        topics, asked = self._cameras[camera], time.monotonic()
        depth, stamp = topics["depth"].after(asked)
        return shot_of(depth, topics["rgb"].after(asked)[0] if rgb else None, stamp)

    def start(self, trajectory: Trajectory) -> None:
        self._allow()
        started = time.monotonic()

        def send(seconds: float) -> bool:
            reading = self.joints()
            planned, _ = trajectory.at(reading.stamp - started)
            off = [a - b for a, b in zip(planned, reading.joints)]
            _, speeds = trajectory.at(seconds)
            late = seconds - trajectory.duration
            if late > _SETTLE or (late > 0.2 and max(map(abs, off)) < _NEAR):
                self._send_speeds((0.0,) * len(speeds))
                return True
            self._send_speeds(tuple(v + _GAIN * e for v, e in zip(speeds, off)))
            return False

        with self._lock:
            self._stream = Stream(_PERIOD, send)

    def poll(self) -> bool:
        return self._stream is None or self._stream.done()

    def start_grip(self, opening: float) -> None:
        self._allow()
        turns = self._closed * (1.0 - opening / self._config.max_opening)
        goal = self._messages.SetFingersPositionGoal()
        goal.fingers.finger1 = goal.fingers.finger2 = goal.fingers.finger3 = turns
        self._hand.send_goal(goal)
        self._gripping = True

    def poll_grip(self) -> bool:
        state = self._hand.get_state()
        if state in _FAILED:
            raise RuntimeError(f"the fingers' action ended in state {state}")
        return state in _RESTING

    def stop(self) -> None:
        """Also disables the arm; the next start enables it again."""
        with self._lock:
            if self._stream:
                self._stream.stop()
            self._send_speeds((0.0,) * len(self._config.chain.joints))
            self._stop_service()
            self._stopped = True
            if self._gripping:
                self._hand.cancel_goal()
                self._gripping = False

    def close(self) -> None:
        self.stop()
        self._ros.signal_shutdown("the bridge is closing")

    def _allow(self) -> None:
        with self._lock:
            if self._stopped:
                self._start_service()
                self._stopped = False

    def _send_speeds(self, speeds: Row) -> None:
        """Radians a second; no joint gets more than its limit."""
        message = self._messages.JointVelocity()
        for i, (speed, joint) in enumerate(zip(speeds, self._config.chain.joints)):
            limited = min(joint.speed, max(-joint.speed, speed))
            setattr(message, f"joint{i + 1}", math.degrees(limited))
        self._speeds.publish(message)
