from __future__ import annotations

from dataclasses import replace

import pytest

from probe.agents.question_classifier import QuestionClassifier
from probe.errors import BadData
from probe.scores.marking import roster_of_tasks
from probe.train.baselines import floors
from probe.train.held_out import markdown, standings
from run_folders import DEMO
from score_rows import faulty, roster, row

TASKS = ["find-0", "find-1", "size-0", "size-1", "beneath-0", "beneath-1"]


def test_what_nobody_learnt_is_apart():
    rights = [1, 0, 1, 1, 0, 0]
    base = [row(task, right, agent="base") for task, right in zip(TASKS, rights, strict=True)]
    student = [row(task, agent="student") for task in TASKS]
    found = standings([*student, *base], roster(*TASKS), ["beneath"])
    assert [it.entrant.agent for it in found] == ["student", "base"]
    second = found[1]
    assert second.trained is not None and second.held_out is not None
    # Find 1 of 2, Size 2 of 2; Beneath none.
    assert second.trained.macro.headline.value == pytest.approx(0.75)
    assert second.held_out.macro.headline.value == 0.0
    lines = markdown(found).splitlines()
    assert (
        lines[0]
        == "|  | episodes | n | macro, trained types | find | size | **beneath**, held out (n) |"
    )
    cells = [cell.strip() for cell in lines[3].strip("|").split("|")]
    assert cells[:3] == ["base, agentic", "6", "4"] and cells[3].startswith("75.0 (")
    assert cells[4:6] == ["50", "100"] and cells[6].startswith("0.0 (0-") and "(2)" in cells[6]


def test_who_ran_only_what_is_held_out_leaves_the_other_columns_empty():
    late = [row(task, agent="late") for task in TASKS[4:]]
    for rows in ([row(task) for task in TASKS] + late, late + [row(task) for task in TASKS]):
        lines = markdown(standings(rows, roster(*TASKS), ["beneath"])).splitlines()
        (line,) = (it for it in lines if "late" in it)
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        assert len(cells) == len(lines[0].strip("|").split("|"))
        assert cells[2:6] == ["0", "", "", ""] and cells[6].startswith("100.0 (")


def test_a_missing_run_gives_no_number():
    rows = [row("find-0"), faulty("find-1"), row("size-0"), row("size-1")]
    text = markdown(standings(rows, roster(*TASKS[:4]), ["beneath"]))
    # Find is right in one of two at least, and in both at most.
    assert "incomplete: 75-100" in text and "beneath" not in text


def test_floors_say_what_the_suites_answers_say():
    rows = floors(DEMO, ["beneath"], {})
    (name,) = {it.agent for it in rows}
    letter = name.removeprefix("always-")
    found = {it.task: it.correct for it in rows}
    for task in DEMO.tasks:
        offered = [option.letter for option in task.options]
        said = letter if letter in offered else offered[-1]
        # Whoever names a thing in Find has to point at it as well.
        named = next(option.text for option in task.options if option.letter == said)
        pointless = task.question_type == "find" and not named.startswith("None")
        if letter != "none":
            assert found[task.id] == (said == task.answer and not pointless)


@pytest.mark.parametrize("letter", "ABCD")
def test_the_best_constant_answer_is_taken(letter):
    count = next(task for task in DEMO.tasks if task.question_type == "count")
    beneath = next(task for task in DEMO.tasks if task.question_type == "beneath")
    other = "A" if letter == "B" else "B"
    tasks = [
        *(replace(count, id=f"count-{n:08x}", answer=letter) for n in range(2)),
        replace(count, id="count-00000009", answer=other),
        # What is held out doesn't count.
        *(replace(beneath, id=f"beneath-{n:08x}", answer=other) for n in range(9)),
    ]
    rows = floors(replace(DEMO, tasks=tuple(tasks)), ["beneath"], {})
    assert {row.agent for row in rows} == {f"always-{letter}"}


def test_there_must_be_something_to_be_best_at():
    with pytest.raises(BadData, match="--types: leaves no type of demo that was trained"):
        floors(DEMO, [task.question_type for task in DEMO.tasks], {})


def test_question_only_is_asked_only_what_it_has_learnt():
    learnt = {"count": QuestionClassifier(tasks=9, weights={"@1": 1.0})}
    others = {task.question_type for task in DEMO.tasks} - {"count"}
    rows = floors(DEMO, others, learnt)
    asked = [it for it in rows if it.agent == "question-only"]
    assert {(it.question_type, it.answer) for it in asked} == {("count", "B")}
    line = markdown(standings(rows, roster_of_tasks(DEMO.tasks), others)).splitlines()[-1]
    assert line.startswith("| question-only") and line.endswith("| 50 |" + "  |" * len(others))
    with pytest.raises(BadData, match=r"question-only: has learnt nothing about find\."):
        floors(DEMO, others - {"find"}, learnt)
