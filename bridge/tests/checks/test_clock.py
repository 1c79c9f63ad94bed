"""What looks at a clock tell."""

from __future__ import annotations

import math

import pytest

from bridges import TOKEN, Running
from faults import plant
from probe_bridge.checks.clock import ClockWatch, Look, judged
from probe_bridge.checks.messages import check_messages


def looks(jump: float = 0.0, drift: float = 0.0, ever: float = 0.01, late: float = 0.004):
    """A minute of looks; answers take a while, first on the way there, then on the way back."""
    for k in range(600):
        true = 5.0 + 0.1 * k
        robot = 1000 + true * (1 + drift) + jump * (k > 300)
        yield Look(true - late * (k % 2) - ever, robot, true + late * (1 - k % 2) + ever)


@pytest.mark.parametrize("jump", [0.1, -0.1, 3.0, -50.0])
def test_a_jump(jump: float):
    outcome = judged(list(looks(jump)))
    assert outcome.fault == "clock jump"
    assert outcome.measures[0].value == pytest.approx(jump, abs=0.04)


@pytest.mark.parametrize("drift", [0.003, -0.003])
def test_a_drift(drift: float):
    assert judged(list(looks(drift=drift))).fault == "clock drift"


def test_a_good_clock_read_over_a_bad_link():
    outcome = judged(list(looks(drift=20e-6, ever=0.2, late=0.3)))
    assert outcome.verdict == "passed"
    good = judged(list(looks(drift=20e-6)))
    assert math.isclose(good.measures[2].value, 20, abs_tol=80)


@pytest.mark.parametrize("seed", range(4))
def test_a_jump_of_a_robot(bridge: Running, seed: int):
    plant(bridge.robot, "clock jump", seed)
    clock = ClockWatch()
    for _ in range(2):
        assert check_messages(bridge.address, TOKEN, None, clock).verdict == "passed"
    assert clock.outcome().fault == "clock jump"
