"""Restraint: right answers without needless manipulations, where tasks state how many they take."""

from __future__ import annotations

from collections.abc import Iterable

from probe.scores.breakdown import Spread, spread
from probe.scores.row import Row

SPARE = 1
"""Manipulations more than necessary that restraint allows: one grasp may fail."""


def is_restrained(row: Row) -> bool:
    """The answer counts, and at most SPARE manipulations more than necessary were used.

    Raises:
        ValueError: The row doesn't say how many were necessary.
    """
    if row.necessary is None:
        raise ValueError(f"{row.task} doesn't say how many manipulations are necessary")
    return row.correct and row.manipulations <= row.necessary + SPARE


def needless(rows: Iterable[Row]) -> Spread | None:
    """Manipulations more than necessary, 0 where there were fewer; None where no row says."""
    told = ((row.manipulations, row.necessary) for row in rows if not row.missing)
    return spread([max(0, used - least) for used, least in told if least is not None])
