"""What a person at a table may know, as a value and as JSON; no table, no truth but feedback."""

from __future__ import annotations

import json
from dataclasses import dataclass, replace
from typing import Any

from probe.episodes.grading import budget_of
from probe.episodes.remarks import Remark
from probe.interfaces.human.call_entries import CallEntry, handles_of
from probe.interfaces.human.feedback import Feedback
from probe.interfaces.human.progress import HumanProgress
from probe.tasks.task import Task
from probe.tasks.type_rules import rules_of
from probe.toolshed.toolshed import MANIPULATIONS, TURNS


@dataclass(frozen=True)
class State:
    """All that a person's page shows.

    Attributes:
        number: Of the question, from 1; 0 before the first and when all are done.
        total: Questions of the suite.
        done: Questions that this person is through with.
        question: Its words; empty while there is none.
        options: Letter and text of each.
        asks_point: Whether the answer takes a point.
        entries: Of each call so far.
        manipulations: That have been carried out.
        budget: Manipulations that the question allows.
        pictures: How many there are.
        doing: What is going on, in words; None if it is the person's turn.
        trouble: What went wrong on our side, in words.
        over: Whether this question's episode has ended.
        stopped: Whether the person ended it without an answer.
        ambiguous, note: What the person said of the question.
        practice: Whether nothing of this counts.
        feedback: In practice, what was right in the question that is over.
    """

    number: int = 0
    total: int = 0
    done: int = 0
    question: str = ""
    options: tuple[tuple[str, str], ...] = ()
    asks_point: bool = False
    entries: tuple[CallEntry, ...] = ()
    manipulations: int = 0
    budget: int = MANIPULATIONS
    pictures: int = 0
    doing: str | None = None
    trouble: str | None = None
    over: bool = False
    stopped: bool = False
    ambiguous: bool = False
    note: str = ""
    practice: bool = False
    feedback: Feedback | None = None


def between(state: State, progress: HumanProgress) -> State:
    """No question: before the first, between two, and when all are done."""
    return State(
        total=progress.total,
        done=progress.done,
        over=True,
        doing=state.doing,
        practice=state.practice,
    )


def at_table(state: State, place: int, task: Task, said: Remark | None) -> State:
    """A question of the suite, nothing done yet.

    Args:
        state: Before.
        place: Of the question, from 0.
        task: Only its words are taken.
        said: What the person has said of it.
    """
    return replace(
        state,
        number=place + 1,
        question=task.question,
        options=tuple((option.letter, option.text) for option in task.options),
        asks_point=rules_of(task.question_type).pointed,
        budget=budget_of(task),
        ambiguous=said is not None and said.ambiguous,
        note="" if said is None else said.note,
    )


def as_json(state: State) -> dict[str, Any]:
    """A state as the page reads it."""
    return {
        "number": state.number,
        "total": state.total,
        "done": state.done,
        "question": state.question,
        "options": state.options,
        "asksPoint": state.asks_point,
        "entries": [_entry_json(entry) for entry in state.entries],
        "objects": handles_of(state.entries),
        "turnsLeft": max(0, TURNS - len(state.entries)),
        "manipulationsLeft": state.budget - state.manipulations,
        "pictures": state.pictures,
        "doing": state.doing,
        "trouble": state.trouble,
        "over": state.over,
        "stopped": state.stopped,
        "remark": {"ambiguous": state.ambiguous, "note": state.note},
        "practice": state.practice,
        "feedback": _feedback_json(state.feedback),
    }


def _feedback_json(feedback: Feedback | None) -> dict[str, Any] | None:
    if feedback is None:
        return None
    return {
        "correct": feedback.correct,
        "verdict": feedback.verdict,
        "reason": feedback.reason,
        "pictures": len(feedback.pictures),
    }


def _entry_json(entry: CallEntry) -> dict[str, Any]:
    arguments: dict[str, Any] = {}
    if isinstance(values := entry.call.values, dict):
        arguments.update(values)
    return {
        "tool": entry.call.name,
        "arguments": {name: json.dumps(value) for name, value in arguments.items()},
        "status": entry.status,
        "text": entry.text,
        "picture": entry.picture,
        "fresh": entry.fresh,
    }
