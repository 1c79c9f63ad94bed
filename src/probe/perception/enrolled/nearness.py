"""How likely it is that what shows is a thing that was enrolled, by the looks of both."""

from __future__ import annotations

import numpy as np

from probe.perception.enrolled.signature import Signature
from probe.types import Array

_SMALLEST = 1e-3

_WEIGHTS = np.array([1.7, 6.3, 6.0, -3.9, -5.1, 0.9])
_BIAS = -7.0
"""Fitted to 125 segments of four piles of 12 to 15 of 25 procedural objects, seen from above and
from the front, so that the probabilities of all objects and of none of them add up to 1."""


def odds(seen: Signature, known: Signature) -> float:
    """Logarithm of the odds that what shows is what was enrolled so, rather than nothing known."""
    return float(comparison(seen, known) @ _WEIGHTS + _BIAS)


def comparison(seen: Signature, known: Signature) -> Array:
    """What tells for or against a pair, shape (6,).

    Whatever lies before a thing may hide a part of it, but nothing adds to it: a surface of a
    colour can only be as large as the known one, and a side only as long.

    Returns:
        Agreement of the colours; share of what shows that the known surface explains, and share
        of the known surface that shows; how much longer and how much wider it is than known, as
        logarithms; whether the outlines go by the same word.
    """
    common = float(np.minimum(seen.area * seen.colours, known.area * known.colours).sum())
    longer = np.log(max(seen.length, _SMALLEST) / max(known.length, _SMALLEST))
    wider = np.log(max(seen.width, _SMALLEST) / max(known.width, _SMALLEST))
    return np.array(
        [
            np.sqrt(seen.colours * known.colours).sum(),
            common / seen.area,
            common / known.area,
            max(longer, 0.0),
            max(wider, 0.0),
            float(seen.outline == known.outline),
        ]
    )
