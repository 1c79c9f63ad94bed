"""Scores arranged as the tables of a report. Values only; templates print them."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass

from probe.scores.breakdown import Effort, Spread
from probe.scores.missing import Gap
from probe.scores.row import Entrant
from probe.scores.scorecard import Figure, Scorecard

_MEASURES: tuple[tuple[str, str], ...] = (
    ("turns", "turns"),
    ("manipulations", "manipulations"),
    ("perceptions", "looks and searches"),
    ("seconds_agent", "seconds, agent"),
    ("seconds_tools", "seconds, tools"),
    ("tokens_in", "tokens in"),
    ("tokens_out", "tokens out"),
    ("cost", "cost, US dollars"),
)
"""Fields of Effort, and their words."""


@dataclass(frozen=True)
class TypeTable:
    """Accuracies with a column for each type and each part of one.

    Attributes:
        columns: Name of each, and how many tasks it has.
        rows: Of each entrant, the figures in that order.
    """

    columns: tuple[tuple[str, int], ...]
    rows: tuple[tuple[Scorecard, tuple[Figure, ...]], ...]


@dataclass(frozen=True)
class EffortTable:
    """One measure of what was done, for each entrant."""

    name: str
    rows: tuple[tuple[Entrant, Spread | None], ...]


@dataclass(frozen=True)
class Missing:
    """What one entrant lacks, reasons apart."""

    entrant: Entrant
    rows: int
    never: tuple[Gap, ...]
    failed: tuple[Gap, ...]
    question_types: tuple[tuple[str, int], ...]


def type_table(cards: Sequence[Scorecard]) -> TypeTable:
    """Every type, then its parts; all entrants were given the same suite."""
    rows = tuple((card, (*card.question_types, *card.parts)) for card in cards)
    figures = rows[0][1] if rows else ()
    return TypeTable(tuple((figure.name, figure.tasks) for figure in figures), rows)


def effort_table(cards: Sequence[Scorecard]) -> list[EffortTable]:
    """Each measure that at least one entrant says anything of."""
    tables = [
        EffortTable(words, tuple((card.entrant, _spread(card.effort, name)) for card in cards))
        for name, words in _MEASURES
    ]
    return [table for table in tables if any(spread for _, spread in table.rows)]


def unknown_measures(cards: Sequence[Scorecard]) -> list[str]:
    """Measures that no record says anything of."""
    known = {table.name for table in effort_table(cards)}
    return [words for _, words in _MEASURES if words not in known]


def missing_table(cards: Sequence[Scorecard]) -> list[Missing]:
    """What each entrant lacks; nobody who lacks nothing."""
    return [_missing(card) for card in cards if card.gaps]


def _missing(card: Scorecard) -> Missing:
    never = tuple(gap for gap in card.gaps if gap.reason == "never run")
    question_types = Counter(gap.question_type for gap in card.gaps)
    return Missing(
        entrant=card.entrant,
        rows=card.macro.headline.rows,
        never=never,
        failed=tuple(gap for gap in card.gaps if gap not in never),
        question_types=tuple(sorted(question_types.items())),
    )


def _spread(effort: Effort, name: str) -> Spread | None:
    return getattr(effort, name)
