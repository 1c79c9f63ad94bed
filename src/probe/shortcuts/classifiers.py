"""Simple classifiers, always judged on tasks that they weren't trained on. The home of sklearn.

Each task is predicted by a classifier that was trained on tasks before it alone, in an order that
is drawn (prequential evaluation: Dawid, J. R. Stat. Soc. A 147(2), 1984). Tasks come in whole
blocks, each even in all that was planned, so that what is common in one block by plan isn't rare in
the next: features that tell nothing then predict as well as a guess. In cross-validation they
don't: what is common in one fold by luck is predicted in the others, and their errors go together.
"""

from __future__ import annotations

import warnings
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from typing import Any

import numpy as np

from probe.agents.text_features import Features
from probe.errors import MissingExtra
from probe.scene.seeds import generator
from probe.types import Array

FEWEST_TASKS = 70
"""With fewer tasks there is nothing to learn from."""

WARM_UP = 0.2
"""Least share of the tasks that are only trained on."""

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
    model: Model,
    told: Sequence[Sequence[Features]],
    right: Sequence[int],
    blocks: Sequence[int],
    seed: int = 0,
) -> dict[int, int]:
    """The option that a classifier chooses, by the place of the task; see this file's docstring.

    Each option is a row: is it the right one? The likeliest option of a task is chosen, by lot
    among several.

    Args:
        model: Makes the classifier.
        told: Features of each option, by task.
        right: Place of each task's right option.
        blocks: Number of each task's block.
        seed: Of the order and the lots.

    Returns:
        Nothing where too few tasks, or no features that several tasks have, leave nothing to
        learn; else all tasks but those of the warm-up.
    """
    names, rows = table(told)
    if len(told) < FEWEST_TASKS or not names:
        return {}
    task = np.repeat(np.arange(len(told)), [len(options) for options in told])
    answers = is_right(told, right)
    rng = generator(seed, "order")
    turn = _rounds(blocks, rng)
    chosen: dict[int, int] = {}
    for number in range(1, int(turn.max()) + 1):
        known, new = turn[task] < number, turn[task] == number
        chances = _trained(model, rows[known], answers[known], rows[new])
        chances = chances + rng.random(len(chances)) * 1e-9
        for one in np.unique(task[new]):
            chosen[int(one)] = int(chances[task[new] == one].argmax())
    return chosen


def _rounds(blocks: Sequence[int], rng: np.random.Generator) -> Array:
    """In which round each task is predicted, shape (n,); 0 is the warm-up, where none is.

    Each round is a block. Those that lack tasks come first: they may be uneven.
    """
    numbers, block, counts = np.unique(blocks, return_inverse=True, return_counts=True)
    lot = rng.permutation(len(numbers))
    order = np.lexsort((lot, counts == counts.max()))
    before = np.concatenate([[0], np.cumsum(counts[order])[:-1]])
    warm = int(np.count_nonzero(before < WARM_UP * len(block)))
    turn = np.empty(len(numbers), dtype=int)
    turn[order] = np.maximum(np.arange(len(numbers)) - warm + 1, 0)
    return turn[block]


def _trained(model: Model, rows: Array, answers: Array, new: Array) -> Array:
    """Chance that each new row is right, shape (n,)."""
    with warnings.catch_warnings():
        # A feature may be the same in all rows that are known so far.
        warnings.simplefilter("ignore")
        return model().fit(rows, answers).predict_proba(new)[:, 1]


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
