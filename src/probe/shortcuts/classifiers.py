"""Simple classifiers, always judged on tasks that they weren't trained on. The home of sklearn."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from probe.agents.texts import Features
from probe.errors import MissingExtra
from probe.scene.seeds import generator
from probe.types import Array

FOLDS = 5
FEWEST_TASKS = 20
"""With fewer tasks there is nothing to learn from."""

_SUPPORT = 5
_NEIGHBOURS = 25
_TREES = 60

Model = Callable[[], Any]
"""Makes a fresh sklearn classifier."""


def models() -> Mapping[str, Model]:
    """The classifiers by name.

    Raises:
        MissingExtra: scikit-learn isn't installed.
    """
    try:
        from sklearn.ensemble import HistGradientBoostingClassifier
        from sklearn.linear_model import LogisticRegression
        from sklearn.neighbors import KNeighborsClassifier
        from sklearn.pipeline import make_pipeline
        from sklearn.preprocessing import StandardScaler
    except ImportError as error:
        raise MissingExtra("The no-shortcut test", "shortcuts") from error
    return {
        "logistic": lambda: make_pipeline(
            StandardScaler(), LogisticRegression(C=0.1, max_iter=2000)
        ),
        "boosting": lambda: HistGradientBoostingClassifier(
            max_iter=_TREES, learning_rate=0.1, max_leaf_nodes=15, random_state=0
        ),
        "neighbours": lambda: make_pipeline(
            StandardScaler(), KNeighborsClassifier(n_neighbors=_NEIGHBOURS, weights="distance")
        ),
    }


def guesses(
    model: Model, told: Sequence[Sequence[Features]], right: Sequence[int], seed: int = 0
) -> list[int] | None:
    """The option that a classifier chooses in each task, trained on other tasks alone.

    Each option is a row: is it the right one? The likeliest option of a task is chosen, by lot
    among several.

    Args:
        model: Makes the classifier.
        told: Features of each option, by task.
        right: Place of each task's right option.
        seed: Of the folds and lots.

    Returns:
        None where too few tasks, or no features that several tasks have, leave nothing to learn.
    """
    if len(told) < FEWEST_TASKS:
        return None
    rows = table(told)
    if rows.shape[1] == 0:
        return None
    counts = [len(options) for options in told]
    answers = np.concatenate(
        [np.arange(count) == place for count, place in zip(counts, right, strict=True)]
    )
    groups = np.repeat(np.arange(len(told)), counts)
    chances = _out_of_fold(model, rows, answers, groups, seed)
    lots = generator(seed, "lots").random(len(chances)) * 1e-9
    parts = np.split(chances + lots, np.cumsum(counts)[:-1])
    return [int(part.argmax()) for part in parts]


def table(told: Sequence[Sequence[Features]]) -> Array:
    """All options as rows, shape (n, k), without features that hardly any option has."""
    from sklearn.feature_extraction import DictVectorizer

    every = [dict(option) for options in told for option in options]
    matrix = DictVectorizer(sparse=False).fit_transform(every)
    return matrix[:, ((matrix != 0).sum(axis=0) >= _SUPPORT) & (np.ptp(matrix, axis=0) > 0)]


def _out_of_fold(model: Model, rows: Array, answers: Array, groups: Array, seed: int) -> Array:
    """Chance of each row to be right by a classifier that saw no row of its task."""
    from sklearn.model_selection import GroupKFold

    chances = np.zeros(len(rows))
    folds = GroupKFold(n_splits=FOLDS, shuffle=True, random_state=seed)
    for train, test in folds.split(rows, answers, groups):
        with warnings.catch_warnings():
            # A feature may be constant in one fold.
            warnings.simplefilter("ignore")
            fitted = model().fit(rows[train], answers[train])
            chances[test] = fitted.predict_proba(rows[test])[:, 1]
    return chances
