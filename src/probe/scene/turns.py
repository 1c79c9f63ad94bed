"""In which order things are drawn: at random, those that lead first."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from probe.assets.spec import ObjectSpec

Leads = Callable[[ObjectSpec], bool]
"""Whether a thing comes before all others; see Library.leads()."""


def nobody(spec: ObjectSpec) -> bool:
    """All are alike."""
    return False


def in_turn(
    specs: Sequence[ObjectSpec], leads: Leads, rng: np.random.Generator
) -> list[ObjectSpec]:
    """Things in random order, those that lead before all others."""
    order: list[int] = rng.permutation(len(specs)).tolist()
    return sorted((specs[index] for index in order), key=lambda spec: not leads(spec))
