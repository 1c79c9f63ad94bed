"""Learns the question-only classifier from training tasks. The same tasks, the same bytes."""

from __future__ import annotations

from collections.abc import Sequence

from probe.agents.question_classifier import (
    QuestionClassifier,
    QuestionClassifierDocument,
    question_features,
)
from probe.shortcuts.classifiers import is_right, linear_weights, table
from probe.tasks.task import LETTERS, QUESTION_TYPES, Task

_DIGITS = 3


def learn(tasks: Sequence[Task]) -> QuestionClassifierDocument:
    """Weights of each type that has tasks, in the order of the types.

    Raises:
        MissingExtra: scikit-learn isn't installed.
    """
    # By id, so that the order of files makes no difference.
    once = sorted({task.id: task for task in tasks}.values(), key=lambda task: task.id)
    question_types = {
        question_type: [task for task in once if task.question_type == question_type]
        for question_type in QUESTION_TYPES
    }
    return QuestionClassifierDocument(
        {question_type: _learnt(mine) for question_type, mine in question_types.items() if mine}
    )


def _learnt(tasks: Sequence[Task]) -> QuestionClassifier:
    told = [
        question_features(task.question, tuple(option.text for option in task.options))
        for task in tasks
    ]
    names, rows = table(told)
    if not names:
        return QuestionClassifier(tasks=len(tasks), weights={})
    answers = is_right(told, [LETTERS.index(task.answer) for task in tasks])
    weights = linear_weights(rows, answers).round(_DIGITS).tolist()
    return QuestionClassifier(
        tasks=len(tasks), weights={n: w for n, w in zip(names, weights, strict=True) if w}
    )
