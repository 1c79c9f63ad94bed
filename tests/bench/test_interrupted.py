"""Ctrl-C ends an evaluation with the number of what is missing, however the harness takes it."""

from __future__ import annotations

import asyncio

import pytest

from bench.painted import demo, plan
from probe.bench import evaluation
from probe.bench.evaluation import Participants, evaluate

NESTED = BaseExceptionGroup("unhandled errors in a TaskGroup", [
    ExceptionGroup("of a retry", [RuntimeError("lost")]), KeyboardInterrupt(),
])  # fmt: skip


def evaluated(monkeypatch, tmp_path, raised: BaseException) -> int:
    def harness(*given: object, **named: object) -> None:
        raise raised

    monkeypatch.setattr(evaluation, "run_harness", harness)
    monkeypatch.setattr(evaluation, "greet", lambda models: None)
    monkeypatch.setattr(evaluation, "_model", lambda chosen, name: name)
    return evaluate(plan(tmp_path, "blind", demo(2)), Participants("m"), "none")


@pytest.mark.parametrize(
    "raised",
    [KeyboardInterrupt(), NESTED, BaseExceptionGroup("tasks", [asyncio.CancelledError()])],
)
def test_an_interrupted_harness_leaves_episodes_missing(monkeypatch, tmp_path, raised):
    assert evaluated(monkeypatch, tmp_path, raised) == 2


def test_an_error_of_the_harness_is_no_interruption(monkeypatch, tmp_path):
    with pytest.raises(ExceptionGroup):
        evaluated(monkeypatch, tmp_path, ExceptionGroup("tasks", [RuntimeError("ours")]))
