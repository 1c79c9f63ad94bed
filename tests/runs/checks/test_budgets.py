"""A record may use as many manipulations as its task allows."""

from __future__ import annotations

from dataclasses import replace

from forgeries import TASK, honest
from probe.episodes.grading import answer_form, budget_of
from probe.runs.checks.calls import amiss_in_calls


def amiss(budget: int) -> list[str]:
    return list(amiss_in_calls(honest(), answer_form(TASK), budget))


def test_a_task_allows_ten_unless_it_says_otherwise():
    assert budget_of(TASK) == 10
    assert budget_of(replace(TASK, manipulations=3)) == 3


def test_more_than_it_allows_are_noticed():
    assert amiss(1) == []
    assert amiss(0)[0] == "it has 1 manipulations, and the rules allow 0"
    assert any("can only be refused" in told for told in amiss(0))
