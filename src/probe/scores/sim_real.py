"""Agents in simulation and on a robot, on the same tasks: success, and whether both agree."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from probe.scene.seeds import generator
from probe.scores.correlation import (
    Correlation,
    exact_interval,
    order_p,
    pearson,
    spearman,
    spread_over,
)
from probe.scores.estimates import macro
from probe.scores.intervals import DRAWS, Interval, deviations, student
from probe.scores.missing import present, settled
from probe.scores.pairs import Pair, family
from probe.scores.row import Entrant, Row
from probe.scores.units import Strata, Unit, by_entrant, strata_of, units_of
from probe.types import Array

FEWEST = 3
"""Models for a correlation: with two, r is 1 or -1 whatever they do."""

Rows = Mapping[Entrant, Sequence[Row]]


@dataclass(frozen=True)
class Side:
    """How one agent fared in one place, on the tasks that are compared.

    Attributes:
        success: Macro average over question types, as in all scores.
        interval: Its 95 % interval (stratified t, over tasks).
        runs: Episodes that it rests on.
        interrupted: Episodes that a failure of ours ended, at whatever task; in none of the other
            numbers.
        causes: How many episodes weren't right, by cause.
    """

    success: float
    interval: Interval
    runs: int
    interrupted: int
    causes: Mapping[str, int]


@dataclass(frozen=True)
class Compared:
    """One agent in both places; the difference is that of the robot less simulation."""

    entrant: Entrant
    sim: Side
    real: Side
    difference: Pair


@dataclass(frozen=True)
class Correlated:
    """A correlation over models.

    Attributes:
        value: Of the success rates; None where there are fewer than three models, or all fared
            alike in one of the places.
        over_tasks: 95 % interval over other tasks of the same kinds, for these very models; None
            where a type has one task.
        undefined: Share of its draws that had no correlation; see spread_over().
        over_models: 95 % interval over other models like these; None for Spearman's, for which
            there is no exact one, and for a perfect one.
        p: One-sided, of an order by chance.
    """

    value: float | None
    over_tasks: Interval | None = None
    undefined: float = 0.0
    over_models: Interval | None = None
    p: float | None = None


@dataclass(frozen=True)
class SimReal:
    """What both places say together.

    Attributes:
        tasks: Those that are compared: each agent has a result of each in both places.
        agents: Best on the robot first.
        pearson, spearman: Over these agents.
        tasks_left_out, agents_left_out: Which others there are, and why they don't count.
    """

    tasks: tuple[str, ...]
    agents: tuple[Compared, ...]
    pearson: Correlated
    spearman: Correlated
    tasks_left_out: Mapping[str, str]
    agents_left_out: Mapping[Entrant, str]


def sim_real(sim: Sequence[Row], real: Sequence[Row], seed: int = 0) -> SimReal:
    """Compare what the same agents did at the same tasks in simulation and on a robot.

    Args:
        sim: Rows of tasks that are the same in both places; runs that failed may be there beside
            their repetitions. Settings don't name conditions, in which both places differ.
        real: The same of the robot.
        seed: Of all draws.
    """
    there = {"in simulation": by_entrant(sim), "on the robot": by_entrant(real)}
    first, second = there.values()
    both = [entrant for entrant in first if entrant in second]
    away = {
        entrant: f"isn't there {place}"
        for place, rows in there.items()
        for entrant in sorted({*first, *second} - {*rows})
    }
    lacking = _lacking(both, there)
    tasks = tuple(sorted({row.task for row in (*sim, *real)} - {*lacking})) if both else ()
    if not tasks:
        return SimReal((), (), Correlated(None), Correlated(None), lacking, away)
    shared, there_too = (_only(rows, both, tasks) for rows in there.values())
    lost = [{it: sum(row.missing for row in rows[it]) for it in both} for rows in there.values()]
    agents, r, rho = _compared(both, (shared, there_too), lost, seed)
    return SimReal(tasks, agents, r, rho, lacking, away)


def cause_of(row: Row) -> str:
    """Why an episode wasn't right, as far as its row tells."""
    if row.outcome == "unanswered":
        return "no answer, turns used up" if row.turns_spent else "no answer, it stopped"
    if row.outcome != "wrong":
        return f"right letter, {row.outcome}"
    if row.options > 2 and row.answer == "E":
        return "wrong, none of the above" + ("" if row.manipulated else ", nothing moved")
    return "wrong, things moved" if row.manipulated else "wrong, nothing moved"


def _lacking(both: Sequence[Entrant], there: Mapping[str, Rows]) -> dict[str, str]:
    """Tasks that some agent has no result of, and the first such agent."""
    found: dict[str, str] = {}
    tasks = {row.task for rows in there.values() for some in rows.values() for row in some}
    for place, rows in there.items():
        for entrant in both:
            has = {row.task for row in present(rows[entrant])}
            for task in sorted(tasks - has):
                found.setdefault(task, f"{entrant.agent} has no result {place}")
    return found


def _only(rows: Rows, both: Sequence[Entrant], tasks: Sequence[str]) -> dict[Entrant, list[Row]]:
    return {it: [row for row in rows[it] if row.task in tasks] for it in both}


def _compared(
    both: Sequence[Entrant],
    sides: Sequence[Rows],
    lost: Sequence[Mapping[Entrant, int]],
    seed: int,
) -> tuple[tuple[Compared, ...], Correlated, Correlated]:
    """All agents and both correlations; of simulation and the robot, in this order.

    Args:
        both: Who is in both places.
        sides: Their rows of the tasks that are compared.
        lost: How many of their episodes were interrupted, at any task.
        seed: Of all draws.
    """
    units = [{it: units_of(present(settled(rows[it]))) for it in both} for rows in sides]
    named = [
        {Entrant(it.agent, f"{it.setting}, {place}"): mine for it, mine in side.items()}
        for place, side in zip(("simulation", "robot"), units, strict=True)
    ]
    pairs = family(named[0] | named[1], zip(named[1], named[0], strict=True), seed)
    sim, real = (
        {it: _side(rows[it], mine[it], gone[it]) for it in both}
        for rows, mine, gone in zip(sides, units, lost, strict=True)
    )
    agents = [Compared(it, sim[it], real[it], pair) for it, pair in zip(both, pairs, strict=True)]
    x, y = np.array([[agent.sim.success, agent.real.success] for agent in agents]).T
    in_order = [[sorted(side[it], key=lambda unit: unit.task) for it in both] for side in units]
    drawn = [_redrawn([strata_of(mine) for mine in side], seed) for side in in_order]
    r, rho = (_agreement(x, y, drawn, seed, how) for how in (pearson, spearman))
    agents.sort(key=lambda it: (-it.real.success, -it.sim.success, it.entrant))
    return tuple(agents), r, rho


def _side(rows: Sequence[Row], units: Sequence[Unit], interrupted: int) -> Side:
    done, strata = present(settled(rows)), strata_of(units)
    causes = Counter(cause_of(row) for row in done if not row.correct)
    ranked = dict(sorted(causes.items(), key=lambda it: (-it[1], it[0])))
    return Side(macro(strata), student(strata), len(done), interrupted, ranked)


def _redrawn(strata: Sequence[Strata], seed: int) -> Array | None:
    """Success of each agent over tasks drawn again within types, shape (draws, agents).

    The draws are the same in every call, since the tasks are the same for all and in both places.
    Deviations are widened as those of bootstrap() are. None where a type has one task, which tells
    nothing of others.
    """
    if any(len(values) < 2 for values in strata[0].values()):
        return None
    total = np.zeros((DRAWS, len(strata)))
    for question_type in strata[0]:
        values = np.array([of[question_type] for of in strata]).T
        rng = generator(seed, "sim-real", question_type)
        total += values.mean(axis=0) + deviations(values, rng)
    return total / len(strata[0])


def _agreement(
    x: Array, y: Array, drawn: Sequence[Array | None], seed: int, correlation: Correlation
) -> Correlated:
    value = float(correlation(x, y)) if len(x) >= FEWEST else float("nan")
    if np.isnan(value):
        return Correlated(None)
    first, second = drawn
    over_tasks, undefined = None, 0.0
    if first is not None and second is not None:
        over_tasks, undefined = spread_over(correlation(first, second))
    return Correlated(
        value=value,
        over_tasks=over_tasks,
        undefined=undefined,
        over_models=exact_interval(value, len(x)) if correlation is pearson else None,
        p=order_p(x, y, generator(seed, "sim-real orders"), correlation),
    )
