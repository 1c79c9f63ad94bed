"""All checks together, on a robot that is well and on some that are not."""

from __future__ import annotations

from typing import List

import pytest

from bridges import TOKEN, Running, quick, running
from faults import plant
from probe_bridge.checks.kit import Kit
from probe_bridge.checks.outcome import FAILED, PASSED, Outcome


def checked(bridge: Running, token: str = TOKEN, motions: bool = True) -> List[Outcome]:
    kit = Kit(bridge.address, token, None, lambda outcome: None)
    if kit.reach():
        kit.see_and_move(motions)
    return kit.outcomes


def faults(outcomes: List[Outcome]) -> List[str]:
    return [outcome.fault for outcome in outcomes if outcome.verdict == FAILED]


@pytest.mark.slow
def test_a_robot_that_is_well_passes_all():
    with running(quick(3.0)) as bridge:
        outcomes = checked(bridge)
        assert {o.verdict for o in outcomes} == {PASSED}, faults(outcomes)
        assert [o.check for o in outcomes] == [
            *("token", "version", "messages", "frames of table", "frames of basket"),
            *("home", "joints", "stop", "watchdog", "gripper", "cut link", "home again", "clock"),
        ]
        assert bridge.driver.joints().joints == bridge.robot.config.home


def test_nothing_moves_if_nothing_may(bridge: Running):
    outcomes = checked(bridge, motions=False)
    assert not faults(outcomes)
    assert not bridge.driver.moves
    assert [o.verdict for o in outcomes if o.check == "stop"] == ["skipped"]


def test_after_swapped_axes_nothing_more_is_moved(bridge: Running):
    plant(bridge.robot, "swapped axes", 1)
    outcomes = checked(bridge)
    assert faults(outcomes) == ["swapped axes"]
    after = {o.check: o.verdict for o in outcomes}
    assert after["stop"] == after["gripper"] == after["cut link"] == "skipped"


def test_a_bad_token_is_named(bridge: Running):
    outcomes = checked(bridge, "another-token-that-is-long")
    assert faults(outcomes) == ["bad token"]
    assert [o.verdict for o in outcomes[1:]] == ["skipped", "skipped"]


def test_nobody_there():
    kit = Kit("ws://127.0.0.1:9", TOKEN, None, lambda outcome: None)
    assert not kit.reach()
    assert faults(kit.outcomes) == ["no link"]


@pytest.mark.parametrize(
    ("fault", "seed"),
    [
        ("wrong version", 1),
        ("wrong version", 2),
        pytest.param("silent drop of messages", 1, marks=pytest.mark.slow),
    ],
)
def test_what_is_said_wrongly_is_named(bridge: Running, fault: str, seed: int):
    plant(bridge.robot, fault, seed)
    assert faults(checked(bridge)) == [fault]
    assert not bridge.driver.moves
