"""Fits the weights of perception/sameness.py: which patches belong to one thing."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np
from scipy.optimize import minimize
from segmenting.scenes import Picture

from probe.perception.merging import Merging, Sameness
from probe.perception.patches import Patches, patches
from probe.perception.relief import relief
from probe.perception.sameness import WEIGHTS, evidence
from probe.types import Array

_ROUNDS = 3
_WHILE = 0.1
_PURE = 0.8
_RIDGE = 1e-4

Examples = tuple[Array, Array, Array]
"""Evidence (n, k), whether it is one thing (n,), and what the example weighs (n,)."""


def fit(scenes: Sequence[Picture]) -> tuple[Array, float]:
    """Weights and bias, from the pairs that merging meets on its way.

    The first round sees the pairs of small patches alone; each later one adds those that merging
    with the weights so far comes upon.
    """
    cut = [(picture, patches(relief(picture.frame))) for picture in scenes]
    met = [_examples(picture, start, None) for picture, start in cut]
    weights, bias = _logistic(met)
    for number in range(1, _ROUNDS):
        chances = _chances(weights, bias)
        met += [_examples(picture, start, chances) for picture, start in cut]
        weights, bias = _logistic(met)
        print(f"round {number + 1}: {sum(len(y) for _, y, _ in met)} pairs", flush=True)
    return weights, bias


def told(weights: Array, bias: float) -> str:
    """As it stands in the source."""
    lines = [f'    "{name}": {w:.3f},' for name, w in zip(WEIGHTS, weights, strict=True)]
    return "\n".join(["WEIGHTS = {", *lines, "}", f"BIAS = {bias:.3f}"])


def _chances(weights: Array, bias: float) -> Sameness:
    def chances(borders: Array, first: Array, second: Array) -> Array:
        return 1 / (1 + np.exp(-(evidence(borders, first, second) @ weights + bias)))

    return chances


def _examples(picture: Picture, start: Patches, chances: Sameness | None) -> Examples:
    """All first pairs; with chances, those that merging meets instead, of patches of one thing."""
    merging = Merging(start, chances or _chances(np.zeros(len(WEIGHTS)), 0.0))
    shows = _shows(picture, start)
    found: list[Examples] = []

    def learn(pairs: list[tuple[int, int]]) -> None:
        counts = merging.counts(pairs)
        same = np.array([shows[a].argmax() == shows[b].argmax() for a, b in pairs], float)
        weight = np.sqrt(np.minimum(counts[1][:, 0], counts[2][:, 0]))
        found.append((evidence(*counts), same, weight))

    if chances is None:
        learn([(int(a), int(b)) for a, b in start.pairs])
    else:
        _follow(merging, shows, learn)
    parts = [np.concatenate(part) for part in zip(*found, strict=True)]
    return parts[0], parts[1], parts[2]


def _follow(
    merging: Merging, shows: dict[int, Array], learn: Callable[[list[tuple[int, int]]], None]
) -> None:
    while pair := merging.likeliest(_WHILE):
        beside = [(side, other) for side in pair for other in merging.borders[side]]
        pure = [(a, b) for a, b in beside if _is_pure(shows[a]) and _is_pure(shows[b])]
        if pure:
            learn(pure)
        shows[merging.join(*pair)] = shows[pair[0]] + shows[pair[1]]


def _is_pure(counts: Array) -> bool:
    return bool(counts.max() > _PURE * counts.sum())


def _shows(picture: Picture, start: Patches) -> dict[int, Array]:
    """By patch, how many of its cells show each instance."""
    stride = round(picture.labels.shape[0] / start.numbers.shape[0])
    labels = picture.labels[::stride, ::stride]
    counts = np.zeros((len(start.inside), int(labels.max()) + 1))
    np.add.at(counts, (start.numbers, labels), 1)
    return dict(enumerate(counts))


def _logistic(met: Sequence[Examples]) -> tuple[Array, float]:
    """Weighted logistic regression on standardised evidence, by L-BFGS."""
    x, y, w = (np.concatenate([part[index] for part in met]) for index in range(3))
    mean, spread, w = x.mean(axis=0), x.std(axis=0) + 1e-9, w / w.sum()
    z = np.column_stack([(x - mean) / spread, np.ones(len(x))])
    sign = 2 * y - 1

    def loss(theta: Array) -> tuple[float, Array]:
        margin = sign * (z @ theta)
        slope = -sign * w / (1 + np.exp(np.clip(margin, -500, 500)))
        value = float(w @ np.logaddexp(0, -margin)) + _RIDGE * float(theta @ theta)
        return value, z.T @ slope + 2 * _RIDGE * theta

    theta = minimize(loss, np.zeros(z.shape[1]), jac=True, method="L-BFGS-B").x
    weights = theta[:-1] / spread
    return weights, float(theta[-1] - weights @ mean)
