"""Simple classifiers, always judged on tasks that they weren't trained on. The home of sklearn."""

from __future__ import annotations

import warnings
from collections import Counter
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
_RIDGE = 0.3

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
        from sklearn.pipeline import Pipeline
        from sklearn.preprocessing import StandardScaler
    except ImportError as error:
        raise MissingExtra("The no-shortcut test", "shortcuts") from error
    return {
        "logistic": lambda: Pipeline(
            [("scale", StandardScaler()), ("fit", LogisticRegression(C=0.1, max_iter=2000))]
        ),
        "boosting": lambda: HistGradientBoostingClassifier(
            max_iter=_TREES, learning_rate=0.1, max_leaf_nodes=15, random_state=0
        ),
        "neighbours": lambda: Pipeline(
            [
                ("scale", StandardScaler()),
                ("fit", KNeighborsClassifier(_NEIGHBOURS, weights="distance")),
            ]
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
    _, rows = table(told)
    if rows.shape[1] == 0:
        return None
    counts = [len(options) for options in told]
    answers = is_right(told, right)
    groups = np.repeat(np.arange(len(told)), counts)
    chances = _out_of_fold(model, rows, answers, groups, seed)
    lots = generator(seed, "lots").random(len(chances)) * 1e-9
    parts = np.split(chances + lots, np.cumsum(counts)[:-1])
    return [int(part.argmax()) for part in parts]


def linear_weights(rows: Array, answers: Array) -> Array:
    """Logistic regression's weights of the features, shape (k,).

    Raises:
        MissingExtra: scikit-learn isn't installed.
    """
    try:
        from sklearn.linear_model import LogisticRegression
    except ImportError as error:
        raise MissingExtra("Learning from questions", "shortcuts") from error
    model: Any = LogisticRegression(C=_RIDGE, max_iter=2000)
    return np.asarray(model.fit(rows, answers).coef_[0])


def table(told: Sequence[Sequence[Features]]) -> tuple[list[str], Array]:
    """All options as rows, shape (n, k), and the k names of features.

    Features that hardly any option has, or that are the same in all, are left out.
    """
    every = [option for options in told for option in options]
    counts = Counter(name for option in every for name, value in option.items() if value)
    names = sorted(name for name, count in counts.items() if count >= _SUPPORT)
    column = {name: place for place, name in enumerate(names)}
    matrix = np.zeros((len(every), len(names)))
    for row, option in enumerate(every):
        for name in option.keys() & column.keys():
            matrix[row, column[name]] = option[name]
    varies = np.ptp(matrix, axis=0) > 0
    return [name for name, kept in zip(names, varies, strict=True) if kept], matrix[:, varies]


def is_right(told: Sequence[Sequence[Features]], right: Sequence[int]) -> Array:
    """For each row whether it is its task's right option, bool, shape (n,)."""
    places = [np.arange(len(options)) == place for options, place in zip(told, right, strict=True)]
    return np.concatenate(places)


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
