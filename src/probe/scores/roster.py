"""What a suite consists of, as far as scores care: its tasks, their types, their options."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import NamedTuple

import numpy as np

from probe.scores.row import Row
from probe.tasks.type_rules import rules_of


class Listed(NamedTuple):
    """A task that everybody should have been given.

    Attributes:
        kind: Question type.
        stratum: Part of the type that is also reported apart, else empty.
        options: Number of options to choose from.
    """

    kind: str
    stratum: str
    options: int


Roster = Mapping[str, Listed]
"""Tasks by id."""


def roster_of(rows: Iterable[Row]) -> dict[str, Listed]:
    """All tasks that somebody was given; what nobody was given can't be known of from rows."""
    return {row.task: Listed(row.kind, row.stratum, row.options) for row in rows}


def chance_by_kind(roster: Roster) -> dict[str, float]:
    """What a blind guess among the options gives, by type: the mean over its tasks.

    In Find it gives less, since the point must be hit as well; the letter alone gives this.
    """
    kinds = sorted({listed.kind for listed in roster.values()})
    return {
        kind: float(np.mean([1 / it.options for it in roster.values() if it.kind == kind]))
        for kind in kinds
    }


def naive_by_kind(roster: Roster) -> dict[str, float]:
    """Share that is right by type without moving anything: a guess, or more by a look."""
    chance = chance_by_kind(roster)
    return {kind: max(guessed, rules_of(kind).naive) for kind, guessed in chance.items()}
