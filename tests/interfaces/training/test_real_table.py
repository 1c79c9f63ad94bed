"""Real tables, several at once: rewards are what grading the records again says."""

from __future__ import annotations

import json
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

import probe

pytestmark = pytest.mark.slow

PRACTICE = probe.load_suite(Path(__file__).with_name("practice.json"))
"""Two tasks that `probe collect` made."""


def played(env: probe.ProbeEnv, number: int) -> tuple[str, int, float | None]:
    """Look and answer, rightly on the first two tries; which episode it was and its reward."""
    task = PRACTICE.tasks[number % 2]
    env.reset(task=task.id)
    assert "- object_1 " in env.perceive_scene()
    wrong = next(letter for letter in "AB" if letter != task.answer)
    env.answer_question(task.answer if number < 2 else wrong)
    reward, record = env.get_reward(), env.record
    assert record is not None
    return record.task, record.run, reward


def test_rewards_are_the_grades_of_the_records(tmp_path):
    with (
        probe.training_tables(PRACTICE, tables=4, out=tmp_path) as tables,
        ThreadPoolExecutor(4) as threads,
    ):
        envs = [probe.ProbeEnv(tables) for _ in range(4)]
        rewards = {(task, run): it for task, run, it in threads.map(played, envs, range(4))}
    assert sorted(rewards.values(), key=str) == [0.0, 0.0, 1.0, 1.0]
    assert probe.rescore(tmp_path).complete
    rows = map(json.loads, (tmp_path / "rows.jsonl").read_text().splitlines())
    assert {(row["task"], row["run"]): float(row["correct"]) for row in rows} == rewards
