"""The errors of tools under which a suite's headline scores are taken."""

from __future__ import annotations

from dataclasses import dataclass

from probe.perception.dials import Dials


@dataclass(frozen=True)
class HeadlineErrors:
    """How far tools err in the setting that a suite's scores are compared in.

    Attributes:
        grasp: Standard deviation of the hand's error along x and along y in a grasp, metres.
        push: The same in a push.
        dials: Rates of the detector's errors.
    """

    grasp: float
    push: float
    dials: Dials
