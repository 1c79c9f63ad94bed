"""Point estimates: tasks to types, types to one number; and what guessing would give."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from probe.scores.units import Strata


def macro(strata: Strata) -> float:
    """Unweighted mean over types of each type's mean over tasks."""
    return float(np.mean([values.mean() for values in strata.values()]))


def macro_chance(chance: Mapping[str, float]) -> float:
    """Mean over types; of blind guesses 30 % for four types of five options and two of two."""
    return float(np.mean(list(chance.values())))


def corrected(value: float, chance: float) -> float:
    """Accuracy beyond a floor: 0 for what it gives, 1 for all right; below 0 for worse than it.

    (value - chance) / (1 - chance), the scale of Cohen's kappa (Educ. Psychol. Meas. 20(1), 1960).
    """
    return (value - chance) / (1 - chance)
