"""How runs differ over the types that were trained, compared task by task. Pure."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from itertools import combinations

from probe.scores.estimates import macro
from probe.scores.missing import present, settled
from probe.scores.pairs import Pair, family, share_tasks
from probe.scores.roster import Roster
from probe.scores.row import Row
from probe.scores.units import by_entrant, strata_of, units_of
from probe.train.baselines import SETTING as BLIND


def differences(
    rows: Iterable[Row], roster: Roster, held_out: Collection[str], seed: int = 0
) -> list[Pair]:
    """All pairs that share a task of a trained type, except two that are both blind.

    Args:
        rows: Of one suite.
        roster: All its tasks.
        held_out: Types that nobody was trained on.
        seed: Of the tests.

    Returns:
        Pairs in order of macro averages; p is corrected for their number.
    """
    kept = [it for it in settled(rows) if roster[it.task].question_type not in held_out]
    entrants = by_entrant(present(kept))
    results = {entrant: units_of(some) for entrant, some in entrants.items()}
    ranked = sorted(results, key=lambda entrant: -macro(strata_of(results[entrant])))
    shared = [
        pair
        for pair in combinations(ranked, 2)
        if share_tasks(results, pair) and {it.setting for it in pair} != {BLIND}
    ]
    return family(results, shared, seed)


def markdown(found: Sequence[Pair]) -> str:
    """A table of differences in points with 95 % intervals (t), and p."""
    lines = ["| first | second | n | first less second, points | p | p by Holm |", f"|{'---|' * 6}"]
    lines += [f"| {' | '.join(_cells(pair))} |" for pair in found]
    return "\n".join(lines) + "\n"


def _cells(pair: Pair) -> list[str]:
    low, high = 100 * pair.student.low, 100 * pair.student.high
    less = f"{100 * pair.difference:.1f} ({low:.0f} to {high:.0f})"
    tasks = f"{pair.tasks} ({pair.left_out} left out)" if pair.left_out else str(pair.tasks)
    told = [pair.first.title, pair.second.title, tasks, less]
    return [*told, *(f"{p:.5f}" if p < 0.001 else f"{p:.3f}" for p in (pair.p, pair.adjusted))]
