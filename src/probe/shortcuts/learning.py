"""Learns the question-only classifier from training-pool tasks. The same tasks, the same bytes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from probe.agents.learnt import Learnt, LearntDocument, question_features
from probe.errors import MissingExtra
from probe.tasks.task import KINDS, LETTERS, Task

_SUPPORT = 5
_DIGITS = 3
_REGULAR = 0.3


def learn(tasks: Sequence[Task]) -> LearntDocument:
    """Weights of each type that has tasks, in the order of the types.

    Raises:
        MissingExtra: scikit-learn isn't installed.
    """
    # By id, so that the order of files makes no difference.
    once = sorted({task.id: task for task in tasks}.values(), key=lambda task: task.id)
    kinds = {kind: [task for task in once if task.kind == kind] for kind in KINDS}
    return LearntDocument({kind: _learnt(mine) for kind, mine in kinds.items() if mine})


def _learnt(tasks: Sequence[Task]) -> Learnt:
    try:
        from sklearn.feature_extraction import DictVectorizer
        from sklearn.linear_model import LogisticRegression
    except ImportError as error:
        raise MissingExtra("Learning from questions", "shortcuts") from error
    told = [
        question_features(task.question, tuple(option.text for option in task.options))
        for task in tasks
    ]
    vectors = DictVectorizer(sparse=False)
    rows = vectors.fit_transform([dict(option) for options in told for option in options])
    answers = np.concatenate(
        [
            np.arange(len(options)) == LETTERS.index(task.answer)
            for task, options in zip(tasks, told, strict=True)
        ]
    )
    kept = (rows != 0).sum(axis=0) >= _SUPPORT
    if not kept.any():
        return Learnt(tasks=len(tasks), weights={})
    fitted = LogisticRegression(C=_REGULAR, max_iter=2000).fit(rows[:, kept], answers)
    names = vectors.get_feature_names_out()[kept]
    weights = {
        str(name): round(float(weight), _DIGITS)
        for name, weight in zip(names, fitted.coef_[0], strict=True)
    }
    return Learnt(tasks=len(tasks), weights={name: w for name, w in weights.items() if w})
