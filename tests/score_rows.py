"""Rows and units that tests of scores make by hand."""

from __future__ import annotations

from probe.scores.roster import Listed
from probe.scores.row import Row
from probe.scores.units import Unit

RIGHT_LETTER = "B"


def row(task: str, right: object = True, **changes: object) -> Row:
    """A row of a task whose type is the first word of its id."""
    correct = bool(right)
    values: dict[str, object] = {
        "suite": "s",
        "task": task,
        "question_type": task.split("-")[0],
        "options": 5,
        "agent": "anna",
        "setting": "agentic",
        "run": 0,
        "answer": "B" if correct else "C",
        "right": RIGHT_LETTER,
        "correct": correct,
        "letter_correct": correct,
        "outcome": "right" if correct else "wrong",
        "end": "answered",
        "turns": 4,
        "manipulations": 1,
        "perceptions": 2,
        "turns_spent": False,
        "manipulations_spent": False,
        "manipulated": True,
    }
    return Row.model_validate(values | changes)


def faulty(task: str, **changes: object) -> Row:
    """A row that a failure of ours ended."""
    ended = {"answer": None, "outcome": "unanswered", "end": "fault", "fault": "RenderFailed: gone"}
    return row(task, False, **(ended | changes))


def unit(task: str, *runs: float) -> Unit:
    """A unit of a task whose type is the first word of its id."""
    return Unit(task, task.split("-")[0], runs)


def units(question_type: str, *means: float) -> list[Unit]:
    """Tasks of one type, each run once."""
    return [unit(f"{question_type}-{i}", mean) for i, mean in enumerate(means)]


def roster(*tasks: str, stratum: str = "", options: int = 5) -> dict[str, Listed]:
    return {task: Listed(task.split("-")[0], stratum, options) for task in tasks}
