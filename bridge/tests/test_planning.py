"""Motions keep all limits, or there is none."""

from __future__ import annotations

import random
from typing import List, Tuple

import pytest

from bridges import practice
from limits import broken_limits
from probe_bridge.config_file import read_config
from probe_bridge.errors import BridgeError
from probe_bridge.planning import plan

RAW = practice()
CONFIG = read_config(RAW)
HOME = CONFIG.home


def moved(*changes: Tuple[int, float]) -> Tuple[float, ...]:
    row = list(HOME)
    for joint, change in changes:
        row[joint] += change
    return tuple(row)


def test_random_paths_keep_all_limits_and_pass_their_waypoints():
    rng = random.Random(7)
    planned = 0
    for _ in range(25):
        rows: List[Tuple[float, ...]] = [HOME]
        for _ in range(rng.randint(1, 12)):
            scale = rng.choice([0.02, 0.1, 0.4])
            rows.append(tuple(a + rng.uniform(-scale, scale) for a in rows[-1]))
        try:
            motion = plan(rows, HOME, CONFIG)
        except BridgeError:
            continue
        planned += 1
        assert broken_limits(motion, motion.duration, RAW, samples=150) == []
        assert motion.joints[0] == HOME
        assert motion.joints[-1] == pytest.approx(rows[-1], abs=1e-9)
        assert set(motion.velocities[0]) == set(motion.velocities[-1]) == {0.0}
        for row in rows:
            assert min(max(abs(a - b) for a, b in zip(row, q)) for q in motion.joints) < 1e-6
    assert planned >= 15


def test_a_dense_straight_path_is_as_quick_as_its_two_ends():
    goal = moved((0, -0.8), (5, 0.4))
    dense = [tuple(a + (b - a) * i / 100 for a, b in zip(HOME, goal)) for i in range(101)]
    sparse = plan([HOME, goal], HOME, CONFIG).duration
    assert plan(dense, HOME, CONFIG).duration == pytest.approx(sparse, rel=0.02)


def test_a_slow_joint_makes_all_others_slow():
    raw = practice()
    raw["joints"][5]["speed"] = 0.1
    motion = plan([HOME, moved((0, -0.5), (5, 0.5))], HOME, read_config(raw))
    assert motion.duration > 5.0


def test_the_tools_speed_counts():
    raw = practice(tool_speed=0.05)
    motion = plan([HOME, moved((0, -0.5))], HOME, read_config(raw))
    assert broken_limits(motion, motion.duration, raw, samples=400) == []
    assert motion.duration > 2.5


@pytest.mark.parametrize(
    ("path", "reason"),
    [
        ([HOME, moved((2, 0.7))], "Waypoint 1 turns elbow_joint to 2.900"),
        ([moved((1, 0.2)), HOME], "begins 0.200 rad from where shoulder_lift_joint is"),
        ([HOME, moved((1, 1.2))], "outside its box"),
        ([HOME, *[moved((5, (-1) ** i * 3.0)) for i in range(10)]], "at most"),
    ],
)
def test_refused_with_the_reason(path: List[Tuple[float, ...]], reason: str):
    with pytest.raises(BridgeError, match=reason) as refused:
        plan(path, HOME, CONFIG)
    assert refused.value.kind == "refused"


def test_what_lies_between_waypoints_is_checked():
    there = moved((0, -3.0))
    box = {"lower": [-1.0, -0.6, 0.15], "upper": [0.4, 0.6, 0.9]}
    wide = read_config(practice(tool_box=box))
    assert plan([HOME, there], HOME, wide).duration > 0
    # Both ends are inside this one, but on the way the hand passes x = -0.12.
    box = {"lower": [-1.0, -0.6, 0.15], "upper": [-0.3, 0.6, 0.9]}
    narrow = read_config(practice(tool_box=box))
    with pytest.raises(BridgeError, match="rad along the path, the tool is at"):
        plan([HOME, there], HOME, narrow)


def test_standing_still_is_a_motion_too():
    motion = plan([HOME, HOME], HOME, CONFIG)
    assert motion.duration == 0.0
    assert motion.at(3.0) == (HOME, (0.0,) * 6)


def test_the_same_path_gives_the_same_motion():
    path = [HOME, moved((0, -0.5)), moved((0, -0.5), (3, 0.2))]
    assert plan(path, HOME, CONFIG) == plan(path, HOME, CONFIG)
