"""Runs compared task by task over the types that were trained."""

from __future__ import annotations

import pytest

from probe.train.differences import differences, markdown
from score_rows import faulty, roster, row

TRAINED = [f"{name}-{n}" for name in ("find", "size") for n in range(4)]
TASKS = [*TRAINED, "beneath-0", "beneath-1"]


def rows_of(agent: str, rights: list[int], setting: str = "agentic"):
    return [
        row(task, right, agent=agent, setting=setting)
        for task, right in zip(TASKS, rights, strict=True)
    ]


BASE = rows_of("base", [0] * 10)
STUDENT = rows_of("student", [1, 1, 1, 1, 1, 1, 0, 0, 0, 0])
BLIND = [
    *rows_of("always-E", [1, 0, 0, 0, 0, 0, 0, 0, 1, 1], "blind"),
    *rows_of("question-only", [0] * 10, "blind"),
]


def test_the_better_one_comes_first_and_p_counts_the_signs():
    (pair,) = differences([*BASE, *STUDENT], roster(*TASKS), ["beneath"])
    assert (pair.first.agent, pair.second.agent) == ("student", "base")
    # Find 4 of 4 and Size 2 of 4; six tasks differ, and 2 of 2^6 sums are as far from 0.
    assert pair.difference == pytest.approx(0.75) and pair.tasks == 8
    assert pair.p == pytest.approx(2 / 2**6)


def test_two_blind_rules_arent_compared_and_p_is_corrected_for_the_rest():
    found = differences([*BLIND, *BASE, *STUDENT], roster(*TASKS), ["beneath"])
    names = [(it.first.agent, it.second.agent) for it in found]
    assert len(names) == 5 and ("always-E", "question-only") not in names
    first = next(it for it in found if it.second.agent == "base")
    assert first.adjusted == pytest.approx(min(1, 5 * first.p))


def test_what_is_held_out_or_missing_is_left_out():
    rest = [row(task, agent="late") for task in TASKS[1:]]
    found = differences(
        [*STUDENT, faulty(TASKS[0], agent="late"), *rest], roster(*TASKS), ["beneath"]
    )
    assert [(it.tasks, it.left_out) for it in found] == [(7, 1)]
    assert differences(STUDENT, roster(*TASKS), ["beneath"]) == []
    assert differences([*STUDENT, *BASE], roster(*TASKS), ["beneath", "find", "size"]) == []


def test_the_table_tells_points_and_both_p():
    table = markdown(differences([*BASE, *STUDENT], roster(*TASKS), ["beneath"]))
    cells = [cell.strip() for cell in table.splitlines()[2].strip("|").split("|")]
    assert cells[:3] == ["student, agentic", "base, agentic", "8"]
    assert cells[3].startswith("75.0 (") and cells[4:] == ["0.031", "0.031"]
