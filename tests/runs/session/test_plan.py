"""The session's file, and the order that is drawn from it."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest

from probe.errors import BadData, UnknownName
from probe.runs.session.order import slots_of
from probe.runs.session.plan import SessionPlan, read_plan, tasks_of
from run_folders import DEMO

BENEATH = [task.id for task in DEMO.tasks if task.question_type == "beneath"]

FILE = f"""
suite: demo
tasks: [{", ".join(BENEATH)}]
agents: [scripted, random, always-E]
runs: 3
seed: 4
operator: Jana
"""


def plan_of(path: Path, text: str = FILE) -> SessionPlan:
    path.write_text(text)
    return read_plan(path)


def test_a_file_says_what_is_compared(tmp_path: Path) -> None:
    plan = plan_of(tmp_path / "plan.yaml")
    assert plan.agents == ("scripted", "random", "always-E") and plan.perception == "segmenter"
    assert [task.id for task in tasks_of(plan, DEMO).tasks] == BENEATH


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        (("seed: 4", ""), "seed: Field required"),
        (("random, always-E", "random, random"), "random is named twice"),
        (("runs: 3", "runs: 0"), "runs: "),
        (("operator: Jana", "operator: ' '"), "operator: "),
        (("operator: Jana", "operator: [Jana"), "is no YAML"),
        (("suite: demo", "suite: demo\nperception: oracle"), "perception: "),
    ],
)
def test_a_wrong_field_is_named(tmp_path: Path, change: tuple[str, str], reason: str) -> None:
    with pytest.raises(BadData, match=reason):
        plan_of(tmp_path / "plan.yaml", FILE.replace(*change))


def test_tasks_that_a_robots_record_cant_grade_are_refused(tmp_path: Path) -> None:
    find = next(task.id for task in DEMO.tasks if task.question_type == "find")
    plan = plan_of(tmp_path / "plan.yaml", FILE.replace(BENEATH[1], find))
    with pytest.raises(BadData, match="asks for a point"):
        tasks_of(plan, DEMO)
    with pytest.raises(UnknownName, match="beneath-0"):
        tasks_of(plan.model_copy(update={"tasks": ("beneath-0",)}), DEMO)


def test_agents_come_back_to_back_in_an_order_that_is_drawn_for_each_table(tmp_path: Path) -> None:
    plan = plan_of(tmp_path / "plan.yaml", FILE.replace("runs: 3", "runs: 30"))
    slots = slots_of(plan, plan.agents)
    assert slots == slots_of(plan, plan.agents) and len(slots) == 2 * 30 * 3
    tables = [slots[at : at + 3] for at in range(0, len(slots), 3)]
    for table in tables:
        assert len({(slot.task, slot.run) for slot in table}) == 1
        assert [slot.number for slot in table] == [1, 2, 3]
        assert {slot.agent for slot in table} == set(plan.agents)
    # Of 60 tables each of the 6 orders comes about 10 times.
    counts = Counter(tuple(slot.agent for slot in table) for table in tables)
    assert len(counts) == 6 and max(counts.values()) < 25
    other = slots_of(plan.model_copy(update={"seed": 5}), plan.agents)
    assert other != slots
