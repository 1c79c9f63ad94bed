"""Pictures that are old, or whose figures can't be right."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Dict, List

import pytest

from bridges import TOKEN, Running, practice, running
from faults import FaultyDriver, plant
from probe_bridge.checks.clock import ClockWatch
from probe_bridge.checks.frames import check_frames
from probe_bridge.checks.optics import wrong_optics
from probe_bridge.client import RobotClient
from probe_bridge.config_file import read_config
from probe_bridge.driver import Shot


def fault(bridge: Running) -> str:
    client = RobotClient(bridge.address, TOKEN)
    try:
        return check_frames(client, ClockWatch(), "basket").fault
    finally:
        client.close()


@pytest.mark.parametrize("seed", range(6))
def test_old_pictures(bridge: Running, seed: int):
    """Some of them say honestly how old they are, seeds 4 and 5 don't; but flat ones can't tell."""
    bridge.robot._driver = Uneven(bridge.robot._driver)
    plant(bridge.robot, "stale frames", seed)
    assert fault(bridge) == "stale frames"


class Uneven(FaultyDriver):
    """Pictures that differ, as all real ones do: in their first pixel, and within one."""

    taken = 0

    def frame(self, camera: str, rgb: bool) -> Shot:
        shot = self.well.frame(camera, rgb)
        self.taken += 1
        return shot._replace(depth=(9000 + self.taken).to_bytes(2, "little") + shot.depth[2:])


@pytest.mark.parametrize(("noisy", "expected"), [(True, ""), (False, "stale frames")])
def test_depth_may_be_the_same_each_time_where_colours_are_not(
    bridge: Running, noisy: bool, expected: str
):
    class Steady(FaultyDriver):
        taken = 0

        def frame(self, camera: str, rgb: bool) -> Shot:
            shot = self.well.frame(camera, rgb)
            self.taken += noisy
            depth = (9000).to_bytes(2, "little") + shot.depth[2:]
            colours = bytes([self.taken]) + (shot.rgb or b"")[1:]
            return shot._replace(depth=depth, rgb=colours)

    bridge.robot._driver = Steady(bridge.robot._driver)
    assert fault(bridge) == expected


def test_depth_in_millimetres(bridge: Running):
    plant(bridge.robot, "depth in millimetres", 0)
    assert fault(bridge) == "depth in millimetres"


@pytest.mark.parametrize(
    ("depth", "expected"),
    [(b"\0\0\x10\x27\0\0", "holes"), (b"\1\0", "unit")],
)
def test_depth_that_is_missing_or_impossible(bridge: Running, depth: bytes, expected: str):
    class Other(FaultyDriver):
        def frame(self, camera: str, rgb: bool) -> Shot:
            shot = self.well.frame(camera, rgb)
            many = len(shot.depth) // len(depth)
            return shot._replace(depth=(shot.depth[:2] + depth * many)[: len(shot.depth)])

    bridge.robot._driver = Other(Uneven(bridge.robot._driver))
    assert expected in fault(bridge)


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"fx": 30.0, "fy": 30.0}, "139 degrees"),
        ({"fx": 200.0}, "differ too much"),
        ({"cx": 2.0}, "principal point"),
        ({}, ""),
    ],
)
def test_figures_that_cannot_be_right(change: Dict[str, Any], says: str):
    camera = read_config(practice()).cameras["basket"]
    wrong = wrong_optics("frames", replace(camera, **change))
    assert says in (wrong.text if wrong else "")
    assert (wrong is None) == (not says)


def test_a_slow_picture_is_counted():
    waits: List[float] = [0.0] * 8
    waits[3] = 0.4

    class Losing(FaultyDriver):
        def frame(self, camera: str, rgb: bool) -> Shot:
            import time

            time.sleep(0.05 + waits.pop())
            return self.well.frame(camera, rgb)

    with running(practice()) as bridge:
        bridge.robot._driver = Losing(bridge.robot._driver)
        client = RobotClient(bridge.address, TOKEN)
        outcome = check_frames(client, ClockWatch(), "basket")
        client.close()
    assert outcome.verdict == "passed"
    assert {m.name: m.value for m in outcome.measures}["late ones"] >= 1
