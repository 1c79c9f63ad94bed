"""What is reached without looking at a table: the best constant answer, and the question alone."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import replace
from statistics import fmean

import numpy as np

from probe.agents.baselines import Rule, always, always_none
from probe.agents.question_classifier import QuestionClassifier, most_likely
from probe.episodes.grading import grade_episode, question_of
from probe.errors import BadData
from probe.runs.plan import Job, RunOrder
from probe.runs.work import stopped
from probe.scores.marking import row_of
from probe.scores.row import Row
from probe.tasks.suite import Suite
from probe.tasks.task import LETTERS, Task
from probe.toolshed.result import Answer

SETTING = "blind"
QUESTION_ONLY = "question-only"


def floors(
    suite: Suite, held_out: Collection[str], learnt: Mapping[str, QuestionClassifier]
) -> list[Row]:
    """Rows of the best constant answer over the types that were trained, and of question-only.

    Args:
        suite: What is asked.
        held_out: Types on which the best constant answer isn't chosen.
        learnt: By question-only; nothing leaves it out. It isn't asked about a held-out type that
            it hasn't learnt.

    Raises:
        BadData: No type is left that was trained, or question-only has learnt others.
    """
    trained = {task.question_type for task in suite.tasks} - {*held_out}
    if not trained:
        reason = f"leaves no type of {suite.name} that was trained"
        raise BadData("--types", reason, "Name fewer, or compare runs of a suite with more types")
    if learnt and not trained <= learnt.keys():
        reason = f"has learnt nothing about {', '.join(sorted(trained - learnt.keys()))}"
        remedy = "Let it learn tasks of these types, too, or name them with --types"
        raise BadData("question-only", reason, remedy)
    constants: dict[str, Rule] = {f"always-{letter}": always(letter) for letter in LETTERS}
    constants["always-none"] = always_none
    played = {
        name: [_row(suite, task, name, rule) for task in suite.tasks]
        for name, rule in constants.items()
    }
    best = max(sorted(played), key=lambda name: _macro(played[name], held_out))
    if not learnt:
        return played[best]
    rules = {question_type: most_likely(known.weights) for question_type, known in learnt.items()}
    blind = [
        _row(suite, task, QUESTION_ONLY, rules[task.question_type])
        for task in suite.tasks
        if task.question_type in rules
    ]
    return [*played[best], *blind]


def _row(suite: Suite, task: Task, name: str, rule: Rule) -> Row:
    question = question_of(task)
    letter = rule(question)
    record = stopped(Job(task, 0), RunOrder(name, 1))
    if letter is not None:
        record = replace(record, answer=Answer(letter), end="answered")
    # No place is pointed at, so that no labels are needed.
    score = grade_episode(task, record, np.zeros((0, 0), np.int32))
    return row_of(task, record, score, suite=suite.name, setting=SETTING)


def _macro(rows: Sequence[Row], held_out: Collection[str]) -> float:
    question_types = {row.question_type for row in rows} - set(held_out)
    return fmean(
        fmean(row.correct for row in rows if row.question_type == question_type)
        for question_type in question_types
    )
