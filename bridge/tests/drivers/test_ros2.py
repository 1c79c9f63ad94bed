"""The ROS 2 driver on stand-ins with the shapes of rclpy's and control_msgs' objects."""

from __future__ import annotations

import time
from types import SimpleNamespace
from typing import Any, Callable, Dict, List, Optional

import pytest

from bridges import practice
from fake_modules import install, until
from probe_bridge.config import Config
from probe_bridge.config_file import read_config
from probe_bridge.drivers import open_driver
from probe_bridge.planning import plan

OPTIONS = {
    "trajectory": "/arm/follow_joint_trajectory",
    "joint_states": "/joint_states",
    "gripper": {
        "action": "/hand/gripper_cmd",
        "joint": "finger_joint",
        "open": 0.0,
        "closed": 0.8,
        "effort": 20.0,
    },
    "cameras": [{"name": "table", "rgb": "/rgb", "depth": "/depth"}],
}
CONFIG: Config = read_config(practice(driver=OPTIONS))


class Future:
    """rclpy's: a callback as soon as there is a result."""

    def __init__(self) -> None:
        self.callbacks: List[Callable[[Any], None]] = []
        self.value: Any = None

    def add_done_callback(self, callback: Callable[[Any], None]) -> None:
        self.callbacks.append(callback)

    def result(self) -> Any:
        return self.value

    def finish(self, value: Any) -> None:
        self.value = value
        for callback in self.callbacks:
            callback(self)


class Server:
    """An action's server and client in one; the test decides what it does."""

    def __init__(self) -> None:
        self.goal: Any = None
        self.sent = Future()
        self.result = Future()
        self.cancelled = 0

    def send_goal_async(self, goal: Any) -> Future:
        self.goal, self.sent, self.result = goal, Future(), Future()
        return self.sent

    def accept(self, accepted: bool = True) -> None:
        self.sent.finish(
            SimpleNamespace(
                accepted=accepted,
                cancel_goal_async=self.cancel,
                get_result_async=lambda: self.result,
            )
        )

    def cancel(self) -> None:
        self.cancelled += 1

    def end(self, status: int, **result: Any) -> None:
        self.result.finish(SimpleNamespace(status=status, result=SimpleNamespace(**result)))


class World:
    """What the fake rclpy talks to."""

    def __init__(self) -> None:
        self.topics: Dict[str, Callable[[Any], None]] = {}
        self.servers: Dict[str, Server] = {}
        self.alive = True

    def action_client(self, _node: Any, _kind: Any, name: str) -> Server:
        return self.servers.setdefault(name, Server())

    def subscribe(self, _kind: Any, topic: str, callback: Callable[[Any], None], _qos: Any) -> None:
        self.topics[topic] = callback

    def spin(self, _node: Any, timeout_sec: float) -> None:
        time.sleep(0.01)

    def shutdown(self) -> None:
        self.alive = False

    def states(self, hand: float = 0.0) -> None:
        """Joint states in another order than ours, as controllers give them."""
        names = [joint.name for joint in CONFIG.chain.joints]
        places = dict(zip(names, CONFIG.home), finger_joint=hand, other=9.0)
        order = sorted(places)
        self.topics["/joint_states"](
            SimpleNamespace(name=order, position=[places[name] for name in order])
        )

    @property
    def arm(self) -> Server:
        return self.servers["/arm/follow_joint_trajectory"]

    @property
    def hand(self) -> Server:
        return self.servers["/hand/gripper_cmd"]


def goal(**parts: Any) -> Any:
    return SimpleNamespace(
        Goal=lambda: SimpleNamespace(**{name: SimpleNamespace() for name in parts})
    )


@pytest.fixture
def world(monkeypatch: pytest.MonkeyPatch) -> World:
    world = World()
    node = SimpleNamespace(create_subscription=world.subscribe, destroy_node=lambda: None)
    rclpy = {
        "init": lambda: None,
        "ok": lambda: world.alive,
        "create_node": lambda _: node,
        "spin_once": world.spin,
        "shutdown": world.shutdown,
    }
    install(
        monkeypatch,
        {
            "rclpy": rclpy,
            "rclpy.action": {"ActionClient": world.action_client},
            "rclpy.qos": {"qos_profile_sensor_data": None},
            "sensor_msgs.msg": {"Image": object, "JointState": object},
            "control_msgs.action": {
                "FollowJointTrajectory": goal(trajectory=None),
                "GripperCommand": goal(command=None),
            },
            "trajectory_msgs.msg": {
                "JointTrajectoryPoint": lambda: SimpleNamespace(time_from_start=SimpleNamespace())
            },
        },
    )
    return world


def start(world: World) -> Any:
    driver: Any = open_driver("ros2", CONFIG)
    world.states()
    path = [CONFIG.home, (*CONFIG.home[:5], 0.8)]
    motion = plan(path, CONFIG.home, CONFIG)
    driver.start(motion)
    return driver, motion


def test_joints_are_put_into_our_order(world: World):
    driver = open_driver("ros2", CONFIG)
    world.states()
    assert driver.joints().joints == CONFIG.home
    driver.close()


def test_a_motion_is_one_goal_with_times_and_velocities(world: World):
    driver, motion = start(world)
    sent = world.arm.goal.trajectory
    assert sent.joint_names == [joint.name for joint in CONFIG.chain.joints]
    last = sent.points[-1]
    assert last.positions == list(motion.joints[-1])
    assert set(last.velocities) == {0.0}
    seconds = [p.time_from_start.sec + p.time_from_start.nanosec * 1e-9 for p in sent.points]
    assert seconds == sorted(seconds)
    assert seconds[-1] == pytest.approx(motion.duration, abs=1e-6)
    assert max(b - a for a, b in zip(seconds, seconds[1:])) < 0.06
    assert not driver.poll()
    world.arm.accept()
    assert not driver.poll()
    world.arm.end(4)
    assert driver.poll()
    driver.close()


@pytest.mark.parametrize("accepted_first", [True, False])
def test_stop_cancels_even_what_is_not_accepted_yet(world: World, accepted_first: bool):
    driver, _ = start(world)
    if accepted_first:
        world.arm.accept()
    driver.stop()
    if not accepted_first:
        assert world.arm.cancelled == 0
        world.arm.accept()
    assert world.arm.cancelled == 1
    world.arm.end(5, error_string="cancelled")
    with pytest.raises(RuntimeError, match="status 5 cancelled"):
        driver.poll()
    driver.close()


def test_a_rejected_goal_is_an_error(world: World):
    driver, _ = start(world)
    world.arm.accept(accepted=False)
    with pytest.raises(RuntimeError, match="rejects"):
        driver.poll()
    driver.close()


@pytest.mark.parametrize(
    ("status", "stalled", "fine"), [(4, False, True), (6, True, True), (6, False, False)]
)
def test_the_hand_may_stall_on_a_thing(
    world: World, status: int, stalled: bool, fine: Optional[bool]
):
    driver = open_driver("ros2", CONFIG)
    world.states(hand=0.4)
    assert driver.opening() == pytest.approx(CONFIG.max_opening / 2)
    driver.start_grip(CONFIG.max_opening / 4)
    assert world.hand.goal.command.position == pytest.approx(0.6)
    assert world.hand.goal.command.max_effort == 20.0
    world.hand.accept()
    assert not driver.poll_grip()
    world.hand.end(status, stalled=stalled)
    if fine:
        assert driver.poll_grip()
    else:
        with pytest.raises(RuntimeError, match="the hand"):
            driver.poll_grip()
    driver.close()
    until(lambda: not world.alive)
