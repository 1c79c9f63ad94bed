"""A robot behind a real bridge, whose arm is only computed and whose pictures are flat."""

from __future__ import annotations

import threading
import time
from collections.abc import Generator
from contextlib import contextmanager
from typing import Any

import numpy as np
import pytest
from bridges import TOKEN, Running, running
from probe_bridge.driver import Reading

from probe.errors import ArmInView, BadData, RobotLost
from probe.scene.setup import UR5_TABLE
from probe.station.remote import BASKET_VIEW, RobotStation, connected
from probe.twin.config import twin_config

PARKED = np.array(UR5_TABLE.mount.parked)
FILE: dict[str, Any] = {**twin_config(UR5_TABLE, haste=4.0), "driver": {"distance": 0.9}}


@contextmanager
def station(raw=FILE, looks=1) -> Generator[tuple[RobotStation, Running]]:
    with running(raw) as bridge:
        client = connected(bridge.address, TOKEN)
        try:
            yield RobotStation(client, UR5_TABLE, looks=looks), bridge
        finally:
            client.close()


def test_a_frame_is_what_its_camera_measures_where_the_bridge_says_that_it_stands() -> None:
    with station(looks=3) as (robot, _):
        frame = robot.observe(rgb=True)
        assert frame.camera.world_from_camera == UR5_TABLE.camera("front").world_from_camera
        assert frame.camera.fov_y_deg == pytest.approx(UR5_TABLE.camera("front").fov_y_deg)
        assert frame.depth.shape == (1024, 1024) and np.allclose(frame.depth, 0.9, atol=1e-4)
        assert frame.labels is None and frame.shares is None
        assert frame.rgb is not None and (frame.rgb == (120, 110, 100)).all()
        assert robot.look_into_basket(rgb=False).camera.looks_down


def test_the_arm_moves_and_is_in_view_until_it_is_parked_again() -> None:
    with station() as (robot, _):
        away = PARKED + (0.2, 0.1, -0.1, 0, 0, 0.1)
        assert robot.follow(np.array([away]))
        assert np.allclose(robot.joints(), away, atol=1e-6)
        with pytest.raises(ArmInView):
            robot.observe(rgb=False)
        assert robot.follow(np.array([PARKED]))
        robot.observe(rgb=False)
        assert robot.grip(0.03) == pytest.approx(0.03)
        assert robot.grip(9.0) == pytest.approx(UR5_TABLE.gripper.max_opening)


def test_what_the_robots_side_refuses_ends_the_episode_and_moves_nothing() -> None:
    with station() as (robot, bridge):
        into_the_table = PARKED + (0, 1.7, 0, 0, 0, 0)
        with pytest.raises(RobotLost, match="outside its box"):
            robot.follow(np.array([into_the_table]))
        assert not bridge.driver.moves


def test_a_motion_that_a_person_stops_isnt_one_that_something_held_back() -> None:
    with station({**FILE, **_speeds(0.3)}) as (robot, bridge):
        threading.Timer(0.3, lambda: bridge.robot.halt("stopped", "A person pressed stop.")).start()
        with pytest.raises(RobotLost, match="A person pressed stop"):
            robot.follow(np.array([PARKED + (1.0, 0, 0, 0, 0, 0)]))
        assert robot.joints()[0] < PARKED[0] + 0.9


def test_an_arm_that_is_held_just_short_of_its_goal_hasn_t_arrived(monkeypatch) -> None:
    """By less than makes the bridge stop it, and by more than lets the cameras see the table."""
    assert FILE["trail"] > 0.09
    with station() as (robot, bridge):
        away, free = PARKED + (0.3, 0, 0, 0, 0, 0.3), bridge.driver.joints

        def held() -> Reading:
            joints, stamp = free()
            return Reading((*joints[:5], max(joints[5], PARKED[5] + 0.09)), stamp)

        assert robot.follow(np.array([away]))
        monkeypatch.setattr(bridge.driver, "joints", held)
        assert not robot.follow(np.array([PARKED]))
        with pytest.raises(ArmInView):
            robot.observe(rgb=False)


def _speeds(speed: float) -> dict[str, Any]:
    return {"joints": [{**joint, "speed": speed} for joint in FILE["joints"]]}


def test_pictures_from_before_the_call_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    with station() as (robot, bridge):
        real = bridge.driver.frame
        late = lambda *about: real(*about)._replace(stamp=time.monotonic() - 1.0)  # noqa: E731
        monkeypatch.setattr(bridge.driver, "frame", late)
        with pytest.raises(RobotLost, match=r"front gave a picture that was [12]\.\d s old"):
            robot.observe(rgb=False)


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"cameras": [c for c in FILE["cameras"] if c["name"] != BASKET_VIEW]}, "called 'basket'"),
        ({"home": [*FILE["home"][:5], 0.1]}, "isn't where the set-up parks"),
    ],
)
def test_another_robot_than_the_set_ups_is_refused(changes, said) -> None:
    with pytest.raises(BadData, match=said), station({**FILE, **changes}):
        pass


def test_a_wrong_token_and_nobody_there_are_said() -> None:
    with running(FILE) as bridge:
        with pytest.raises(RobotLost, match="unauthorized"):
            connected(bridge.address, "another token than that one")
        gone = bridge.address
    with pytest.raises(RobotLost, match="lost"):
        connected(gone, TOKEN)
