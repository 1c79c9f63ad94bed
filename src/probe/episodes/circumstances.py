"""Under which circumstances an agent has a try at a task, as one value."""

from __future__ import annotations

from dataclasses import dataclass

from probe.episodes.conditions import AS_FROZEN, Conditions
from probe.episodes.noise import NO_NOISE, Noise
from probe.episodes.perceptions import ORACLE_USED, PerceptionUsed
from probe.scene.viewpoint import Viewpoint


@dataclass(frozen=True)
class Circumstances:
    """All that two tries at a task may differ in, the agent apart.

    Attributes:
        run: Of the agent's runs at the task; each has its own luck.
        noise: How far the hand errs.
        conditions: The dials and the ideal hold; what they say of the table must be so already.
        viewpoint: From where and in which light the table is seen; None for how it was made.
        perception: What the tools see with.
    """

    run: int = 0
    noise: Noise = NO_NOISE
    conditions: Conditions = AS_FROZEN
    viewpoint: Viewpoint | None = None
    perception: PerceptionUsed = ORACLE_USED


PLAIN_TRY = Circumstances()
"""The first run, a hand that never errs, and nothing else than as the task was made."""
