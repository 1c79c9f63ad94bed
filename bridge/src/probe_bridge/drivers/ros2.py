"""Any arm with a ROS 2 trajectory controller. Never tried on hardware.

It sends the whole motion as one goal of control_msgs/FollowJointTrajectory and cancels it to stop;
what an arm does then is its controller's affair (ros2_control's holds its position). If this
process is killed, the controller carries the motion to its end, which was checked beforehand.

Options: "trajectory" (the action's name), "joint_states" (the topic), "gripper": {"action" of
control_msgs/GripperCommand, "joint" of the hand in joint_states, "open" and "closed" (its positions
there), "effort"}, "cameras": a list of {"name", "rgb", "depth"} with the topics' names.
"""

from __future__ import annotations

import threading
import time
from typing import Any, Dict, List

from probe_bridge.config import Config
from probe_bridge.curve import Row
from probe_bridge.driver import Reading, Shot
from probe_bridge.drivers import library
from probe_bridge.drivers.newest import Newest
from probe_bridge.drivers.ros2_goal import Goal
from probe_bridge.drivers.ros_images import shot_of
from probe_bridge.fields import Fields
from probe_bridge.trajectory import Trajectory

_PERIOD = 0.05
_REMEDY = "Source a ROS 2 workspace first: source /opt/ros/*/setup.bash"


class Ros2Driver:
    """Joint states and images from topics, motions and the hand as actions."""

    def __init__(self, config: Config) -> None:
        options = Fields(config.options, "config.driver")
        self._config = config
        self._ros = library("rclpy", _REMEDY)
        self._actions = library("control_msgs.action", _REMEDY)
        self._trajectories = library("trajectory_msgs.msg", _REMEDY)
        self._ros.init()
        self._node = self._ros.create_node("probe_bridge")
        client = library("rclpy.action", _REMEDY).ActionClient
        hand = options.inner("gripper")
        self._hand_joint = hand.text("joint")
        self._open, self._closed = hand.number("open"), hand.number("closed")
        self._effort = hand.number("effort")
        self._arm_action = client(
            self._node, self._actions.FollowJointTrajectory, options.text("trajectory")
        )
        self._hand_action = client(self._node, self._actions.GripperCommand, hand.text("action"))
        hand.end()
        sensors = library("sensor_msgs.msg", _REMEDY)
        self._states = self._listen(options.text("joint_states"), sensors.JointState)
        self._cameras: Dict[str, Dict[str, Newest]] = {
            camera.text("name"): {
                kind: self._listen(camera.text(kind), sensors.Image) for kind in ("rgb", "depth")
            }
            for camera in options.each("cameras")
        }
        options.end()
        self._arm_goal, self._hand_goal = Goal("the arm"), Goal("the hand")
        self._spinning = threading.Thread(target=self._spin, name="rclpy", daemon=True)
        self._spinning.start()

    def _listen(self, topic: str, message: Any) -> Newest:
        newest = Newest(topic)
        # Sensors' quality of service: the newest counts, and a lost one is not sent again.
        quality = library("rclpy.qos", _REMEDY).qos_profile_sensor_data
        self._node.create_subscription(message, topic, newest.put, quality)
        return newest

    def _spin(self) -> None:
        while self._ros.ok():
            self._ros.spin_once(self._node, timeout_sec=0.05)

    def joints(self) -> Reading:
        names = [joint.name for joint in self._config.chain.joints]
        message, stamp = self._states.get()
        return Reading(tuple(self._positions(message, names)), stamp)

    def _positions(self, message: Any, names: List[str]) -> Row:
        """Positions in our order; a message may have any order, and other joints too."""
        places = {name: float(angle) for name, angle in zip(message.name, message.position)}
        missing = [name for name in names if name not in places]
        if missing:
            raise KeyError(f"joint states lack {missing[0]}")
        return tuple(places[name] for name in names)

    def opening(self) -> float:
        message, _ = self._states.get()
        (place,) = self._positions(message, [self._hand_joint])
        share = (place - self._closed) / (self._open - self._closed)
        return self._config.max_opening * min(1.0, max(0.0, share))

    def frame(self, camera: str, rgb: bool) -> Shot:
        topics, asked = self._cameras[camera], time.monotonic()
        depth, stamp = topics["depth"].after(asked)
        return shot_of(depth, topics["rgb"].after(asked)[0] if rgb else None, stamp)

    def start(self, trajectory: Trajectory) -> None:
        goal = self._actions.FollowJointTrajectory.Goal()
        goal.trajectory.joint_names = [joint.name for joint in self._config.chain.joints]
        goal.trajectory.points = [self._point(*state) for state in trajectory.every(_PERIOD)]
        self._arm_goal = Goal("the arm")
        self._arm_goal.follow(self._arm_action.send_goal_async(goal))

    def _point(self, seconds: float, angles: Row, speeds: Row) -> Any:
        point = self._trajectories.JointTrajectoryPoint()
        point.positions, point.velocities = list(angles), list(speeds)
        whole = int(seconds)
        point.time_from_start.sec = whole
        point.time_from_start.nanosec = int((seconds - whole) * 1e9)
        return point

    def poll(self) -> bool:
        return self._arm_goal.ended()

    def start_grip(self, opening: float) -> None:
        share = opening / self._config.max_opening
        goal = self._actions.GripperCommand.Goal()
        goal.command.position = self._closed + share * (self._open - self._closed)
        goal.command.max_effort = self._effort
        self._hand_goal = Goal("the hand", may_stall=True)
        self._hand_goal.follow(self._hand_action.send_goal_async(goal))

    def poll_grip(self) -> bool:
        return self._hand_goal.ended()

    def stop(self) -> None:
        self._arm_goal.cancel()
        self._hand_goal.cancel()

    def close(self) -> None:
        self.stop()
        time.sleep(0.2)  # so that what cancels is sent
        self._ros.shutdown()
        self._spinning.join(2.0)
        self._node.destroy_node()
