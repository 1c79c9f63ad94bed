"""How likely two patches belong to one thing: a logistic regression on what is counted of them.

The weights were fitted by `benchmarks/internals/segmenting/fit.py` on pictures of scanned objects.
"""

from __future__ import annotations

import numpy as np

from probe.types import Array

WEIGHTS = {
    "step": -0.377,
    "step over 1.5 mm": -1.489,
    "valley": -2.246,
    "ridge": -0.467,
    "contrast": -0.037,
    "log border": -0.185,
    "lightness apart": -0.726,
    "hue apart": 0.486,
    "lightness apart over spread": 0.657,
    "hue apart over spread": -1.250,
    "log smaller": -0.268,
    "log larger": -0.337,
    "share of outline": 3.280,
}

BIAS = 14.836


def evidence(borders: Array, first: Array, second: Array) -> Array:
    """What speaks for and against, in the order of the weights.

    Args:
        borders: Counts of the common borders, shape (n, 6), as in Patches.
        first: Counts of the patches on one side, shape (n, 8).
        second: Counts of those on the other side, shape (n, 8).
    """
    length = borders[:, 0]
    along = borders[:, 1:] / length[:, None]
    one, one_spread = _colours(first)
    other, other_spread = _colours(second)
    lightness, hue = _apart(one - other)
    light_spread, hue_spread = _apart((one_spread + other_spread) / 2)
    sizes = np.log(np.column_stack([first[:, 0], second[:, 0]]))
    return np.column_stack(
        [
            along,
            np.log(length),
            lightness / 10,
            hue / 10,
            lightness / (5 + light_spread),
            hue / (4 + hue_spread),
            sizes.min(axis=1),
            sizes.max(axis=1),
            length / np.maximum(np.minimum(first[:, 7], second[:, 7]), 1),
        ]
    )


def sameness(borders: Array, first: Array, second: Array) -> Array:
    """Probability that two patches belong to one thing, shape (n,); arguments as in evidence."""
    score = evidence(borders, first, second) @ np.array(list(WEIGHTS.values())) + BIAS
    return 1 / (1 + np.exp(-score))


def _colours(counts: Array) -> tuple[Array, Array]:
    """Mean and spread of the CIELAB colours of patches, shape (n, 3) each."""
    mean = counts[:, 1:4] / counts[:, :1]
    square = counts[:, 4:7] / counts[:, :1]
    return mean, np.sqrt(np.maximum(square - mean**2, 0))


def _apart(colours: Array) -> tuple[Array, Array]:
    """Lengths along lightness and along hue."""
    return np.abs(colours[:, 0]), np.hypot(colours[:, 1], colours[:, 2])
