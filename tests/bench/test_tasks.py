"""What `inspect eval probe/...` runs: the suite's headline setting, or what somebody asks for."""

from __future__ import annotations

from dataclasses import replace

import pytest

from bench.painted import demo
from probe.bench import tasks
from probe.episodes.conditions import NO_DIALS
from probe.episodes.noise import NO_NOISE, Noise
from probe.perception.dials import Dials
from probe.tasks.headline import HeadlineErrors
from probe.tasks.suite_file import write_suite

EYE = Dials(over=0.14, under=0.08)
HAND = Noise(0.018, 0.004)


@pytest.fixture
def suite(tmp_path):
    told = HeadlineErrors(HAND.grasp, HAND.push, EYE)
    path = tmp_path / "mine.json"
    write_suite(path, replace(demo(2), name="mine", headline=told))
    return str(path)


@pytest.fixture
def plans(monkeypatch):
    """Plans whose folders were looked at."""
    seen = []
    monkeypatch.setattr(tasks, "check_folder", lambda plan, _: seen.append(plan))
    return seen


@pytest.mark.parametrize(
    ("made", "asked", "hand", "eye"),
    [
        (tasks.agentic, {}, HAND, EYE),
        (tasks.agentic, {"noise": "none"}, NO_NOISE, NO_DIALS),
        (tasks.agentic, {"pointer": "self"}, HAND, NO_DIALS),
        (tasks.text_only, {}, HAND, EYE),
        (tasks.text_only, {"noise": "paper"}, Noise(0.018), NO_DIALS),
        (tasks.direct, {}, NO_NOISE, NO_DIALS),
        (tasks.blind, {}, NO_NOISE, NO_DIALS),
    ],
)
def test_tools_err_as_the_suite_says(tmp_path, suite, plans, made, asked, hand, eye):
    made(suite=suite, out=str(tmp_path / "out"), **asked)
    (plan,) = plans
    assert (plan.noise, plan.conditions.dials) == (hand, eye)
    assert plan.conditions.renderer == "own"
