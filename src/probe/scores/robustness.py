"""The same entrants on the same tasks under other conditions: differences by pairs of rows."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass

from probe.errors import ProbeError
from probe.scores.estimates import macro
from probe.scores.missing import gaps_of, present, settled
from probe.scores.pairs import Pair, Results, family
from probe.scores.roster import Roster
from probe.scores.row import Entrant, Row
from probe.scores.units import Unit, by_entrant, strata_of, units_of


class NoCounterpart(ProbeError):
    """Somebody was run under other conditions alone."""

    def __init__(self, entrant: Entrant, label: str) -> None:
        super().__init__(
            f"{entrant.agent} was run under {label!r}, but is not in the plain run. "
            "Run the same agent on both."
        )


@dataclass(frozen=True)
class ConditionEffect:
    """What other conditions do to one entrant.

    Attributes:
        conditions: In a few words.
        pair: Under them, less as frozen; on tasks that have results both ways.
        plain, other: Both macro averages, on those tasks.
        certified: The difference on the tasks whose rules still hold; None if none of them does.
        certified_tasks: How many these are.
        missing: Rows that failed on our side, of both.
        tools: Versions of the tools, first as frozen.
    """

    conditions: str
    pair: Pair
    plain: float
    other: float
    certified: float | None
    certified_tasks: int
    missing: int
    tools: tuple[int, int]


def shifts(
    plain: Sequence[Row],
    others: Mapping[str, Sequence[Row]],
    broken: Mapping[str, Collection[str]],
    roster: Roster,
    seed: int = 0,
) -> list[ConditionEffect]:
    """Each entrant under each of several conditions against itself as frozen, as one family.

    Args:
        plain: Rows of the tasks as they were frozen.
        others: By the conditions' label, rows of the same tasks under them.
        broken: By the same, tasks that are no longer what was certified.
        roster: All tasks.
        seed: Of the draws.

    Raises:
        NoCounterpart: An agent is under other conditions alone.
        NothingShared: Both sides have no task in common.
    """
    results: dict[Entrant, list[Unit]] = {}
    pairs: dict[tuple[Entrant, Entrant], str] = {}
    base = by_entrant(settled(plain))
    results |= {entrant: units_of(present(rows)) for entrant, rows in base.items()}
    missing = {entrant: len(gaps_of(rows, roster)) for entrant, rows in base.items()}
    tools = {entrant: rows[0].tools for entrant, rows in base.items()}
    for label, rows in others.items():
        found = by_entrant(settled(rows))
        results |= {entrant: units_of(present(some)) for entrant, some in found.items()}
        missing |= {entrant: len(gaps_of(some, roster)) for entrant, some in found.items()}
        tools |= {entrant: some[0].tools for entrant, some in found.items()}
        pairs |= {(it, _counterpart(it, label, base)): label for it in found}
    compared = family(results, pairs, seed)
    return [
        _shift(label, pair, results, broken.get(label, ()), missing, tools)
        for pair, label in zip(compared, pairs.values(), strict=True)
    ]


def _counterpart(entrant: Entrant, label: str, base: Mapping[Entrant, object]) -> Entrant:
    plain = Entrant(entrant.agent, entrant.setting.removesuffix(f", {label}"))
    if plain not in base or plain == entrant:
        raise NoCounterpart(entrant, label)
    return plain


def _shift(
    label: str,
    pair: Pair,
    results: Results,
    broken: Collection[str],
    missing: Mapping[Entrant, int],
    tools: Mapping[Entrant, int],
) -> ConditionEffect:
    first, second = _shared(results[pair.first], results[pair.second])
    held = [
        Unit(one.task, one.question_type, (one.mean - other.mean,))
        for one, other in zip(first, second, strict=True)
        if one.task not in broken
    ]
    return ConditionEffect(
        conditions=label,
        pair=pair,
        plain=macro(strata_of(second)),
        other=macro(strata_of(first)),
        certified=macro(strata_of(held)) if held else None,
        certified_tasks=len(held),
        missing=missing[pair.first] + missing[pair.second],
        tools=(tools[pair.second], tools[pair.first]),
    )


def _shared(ones: Sequence[Unit], others: Sequence[Unit]) -> tuple[list[Unit], list[Unit]]:
    """Units of the tasks that both have, in the same order."""
    theirs = {unit.task: unit for unit in others}
    shared = [unit for unit in ones if unit.task in theirs]
    return shared, [theirs[unit.task] for unit in shared]
