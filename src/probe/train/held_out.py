"""Runs side by side, with the types that nobody was trained on apart. Pure."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import dataclass

from probe.scores.missing import settled
from probe.scores.roster import Roster
from probe.scores.row import Entrant, Row
from probe.scores.scorecard import Figure, Scorecard, scorecard
from probe.scores.units import by_entrant


@dataclass(frozen=True)
class EntrantResult:
    """How one entrant fared.

    Attributes:
        entrant: Who, in which setting.
        trained: Over the types of the training; None where the suite has none of them.
        held_out: Over the others; None where the suite has none of them.
    """

    entrant: Entrant
    trained: Scorecard | None
    held_out: Scorecard | None


def standings(
    rows: Iterable[Row], roster: Roster, held_out: Collection[str], seed: int = 0
) -> list[EntrantResult]:
    """Everyone's figures, in the order in which they first appear.

    Args:
        rows: Of one suite.
        roster: All its tasks.
        held_out: Types that nobody was trained on.
        seed: Of the bootstrap.
    """
    kept = settled(rows)
    trained = {it.question_type for it in roster.values()} - {*held_out}
    order = list(dict.fromkeys(row.entrant for row in kept))
    entrants = by_entrant(kept)
    return [
        EntrantResult(
            entrant,
            _card(entrants[entrant], roster, trained, seed),
            _card(entrants[entrant], roster, held_out, seed),
        )
        for entrant in order
    ]


def markdown(found: Sequence[EntrantResult]) -> str:
    """A table: shares of right answers in per cent with 95 % intervals (t), and n tasks."""
    question_types = _types(it.trained for it in found)
    others = _types(it.held_out for it in found)
    head = ["", "episodes", "n", "macro, trained types", *question_types]
    head += [f"**{question_type}**, held out (n)" for question_type in others]
    lines = [f"| {' | '.join(head)} |", f"|{'---|' * len(head)}"]
    lines += [f"| {' | '.join(_cells(each, question_types, others))} |" for each in found]
    return "\n".join(lines) + "\n"


def _cells(each: EntrantResult, question_types: Sequence[str], others: Sequence[str]) -> list[str]:
    runs = sum(card.macro.runs for card in (each.trained, each.held_out) if card)
    cells = [each.entrant.title, str(runs)]
    trained = each.trained
    cells += [str(trained.macro.tasks), _share(trained.macro)] if trained else ["0", ""]
    told = {figure.name: figure for figure in trained.question_types} if trained else {}
    cells += [
        _share(told[question_type], short=True) if question_type in told else ""
        for question_type in question_types
    ]
    held = {figure.name: figure for figure in each.held_out.question_types} if each.held_out else {}
    return cells + [f"{_share(held[it])} ({held[it].tasks})" if it in held else "" for it in others]


def _types(cards: Iterable[Scorecard | None]) -> list[str]:
    return list(
        dict.fromkeys(figure.name for card in cards if card for figure in card.question_types)
    )


def _card(
    rows: Sequence[Row], roster: Roster, question_types: Collection[str], seed: int
) -> Scorecard | None:
    listed = {task: it for task, it in roster.items() if it.question_type in question_types}
    mine = [row for row in rows if row.task in listed]
    return scorecard(mine, listed, seed) if mine else None


def _share(figure: Figure, *, short: bool = False) -> str:
    top, interval = figure.headline, figure.student
    if top.value is None or interval is None:
        return f"incomplete: {100 * top.worst:.0f}-{100 * top.best:.0f}"
    if short:
        return f"{100 * top.value:.0f}"
    return f"{100 * top.value:.1f} ({100 * interval.low:.0f}-{100 * interval.high:.0f})"
