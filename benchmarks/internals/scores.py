"""Whether the statistics hold what they promise: `python benchmarks/internals/scores.py --help`.

Measures internals, not the public API.

Imaginary agents whose chances are known run suites of the size of v1, over and over. Printed are
the share of intervals that hold the truth, the share of tests that find a difference where there
is none, and the differences that are found in 80 % of suites. Then the paper's table, added up.
"""

from __future__ import annotations

import itertools
import math
import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import tyro
from rich.console import Console
from rich.table import Table

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests"))

from imaginary_results import draw_chances, draw_units, two_settings  # noqa: E402
from probe.scores.intervals import Interval, bootstrap, student  # noqa: E402
from probe.scores.pairs import no_difference_p  # noqa: E402
from probe.scores.power import PowerAssumptions, detectable_gap, expected_error  # noqa: E402
from probe.scores.published import RUNS, printed_table, recount  # noqa: E402
from probe.scores.setting_effect import setting_effect  # noqa: E402
from probe.scores.units import Unit, strata_of  # noqa: E402
from probe.types import Array  # noqa: E402

SUITE = printed_table().tasks
MIDDLING = {
    "find": 0.7,
    "compare": 0.8,
    "size": 0.65,
    "count": 0.4,
    "reduce": 0.25,
    "beneath": 0.55,
}
"""About the mean of the paper's agents."""

PROFILES: dict[str, Mapping[str, float]] = {
    "middling": MIDDLING,
    "weak": dict.fromkeys(SUITE, 0.3),
    "strong": dict.fromkeys(SUITE, 0.9),
    "near perfect": dict.fromkeys(SUITE, 0.98),
}
LEVEL, DRAWS = 0.05, 299
out = Console(width=120)


@dataclass(frozen=True)
class Scenario:
    """How two settings of eight agents depend on tasks; see two_settings."""

    name: str
    task: float
    agent: float
    setting: float


SCENARIOS = (
    Scenario("a task is as easy in both settings", 0.4, 0.6, 0.0),
    Scenario("mostly so", 0.4, 0.3, 0.0),
    Scenario("each agent in each setting has its own easy tasks", 0.0, 0.0, 0.0),
    Scenario("agents share what is easy, settings don't: a quarter", 0.0, 0.0, 0.25),
    Scenario("agents share what is easy, settings don't: a half", 0.0, 0.0, 0.5),
    Scenario("a bit of each", 0.3, 0.2, 0.2),
)


def coverage(sims: int, rng: np.random.Generator) -> None:
    """Share of 95 % intervals that hold the truth."""
    table = _table(
        "Coverage of 95 % intervals", "agent", "ICC", "runs", "of", "n", "t", "bootstrap"
    )
    for name, profile in PROFILES.items():
        for icc, runs in ((0.6, 3), (0.6, 1), (0.2, 3), (0.9, 3)):
            suites = [_one(rng, profile, icc, runs) for _ in range(sims)]
            truth = float(np.mean(list(profile.values())))
            row = (name, str(icc), str(runs))
            table.add_row(*row, "macro", str(sum(SUITE.values())), *_held(suites, truth))
            counts = [[unit for unit in suite if unit.question_type == "count"] for suite in suites]
            table.add_row(*row, "count", str(SUITE["count"]), *_held(counts, profile["count"]))
    out.print(table)


def _one(
    rng: np.random.Generator, profile: Mapping[str, float], icc: float, runs: int
) -> list[Unit]:
    means = {question_type: [value] for question_type, value in profile.items()}
    return draw_units(rng, SUITE, means, icc, np.eye(1), runs)[0]


def _held(suites: Sequence[Sequence[Unit]], truth: float) -> tuple[str, str]:
    makers: tuple[Callable[[Mapping[str, Array]], Interval], ...] = (
        student,
        lambda strata: bootstrap(strata, seed=0, draws=1000),
    )
    found = [[make(strata_of(suite)) for suite in suites] for make in makers]
    shares = [np.mean([it.low <= truth <= it.high for it in some]) for some in found]
    return f"{shares[0]:.1%}", f"{shares[1]:.1%}"


def false_alarms(sims: int, rng: np.random.Generator) -> None:
    """How often settings that don't differ on average are told apart at 5 %."""
    columns = "what makes a task easy", "ICC", "plain CMH", "swapped tasks"
    table = _table("False alarms of the test of settings: 8 agents, 2 settings, 3 runs", *columns)
    for scenario in SCENARIOS:
        for icc in (0.3, 0.6):
            plain, swapped = _alarms(scenario, icc, sims, rng)
            table.add_row(scenario.name, str(icc), f"{plain:.1%}", f"{swapped:.1%}")
    out.print(table)


def _alarms(
    scenario: Scenario, icc: float, sims: int, rng: np.random.Generator
) -> tuple[float, float]:
    alike = two_settings(8, task=scenario.task, agent=scenario.agent, setting=scenario.setting)
    means = {question_type: [value] * len(alike) for question_type, value in MIDDLING.items()}
    alarms = np.zeros(2)
    for _ in range(sims):
        entrants = draw_units(rng, SUITE, means, icc, alike, RUNS)
        both = {f"agent {k}": (entrants[k], entrants[8 + k]) for k in range(8)}
        found = setting_effect(both, rng, draws=DRAWS)
        alarms += (found.plain_p <= LEVEL, found.p <= LEVEL)
    return alarms[0] / sims, alarms[1] / sims


def gaps(sims: int, rng: np.random.Generator) -> None:
    """Differences found in 80 % of suites, by formula, and how often they are indeed found."""
    columns = "ICC", "alike", "runs", "v1", "found", "one type", "found", "none found", "3 points"
    table = _table("Differences of two agents that are found with 80 % power, in points", *columns)
    one = {"count": SUITE["count"]}
    for icc, alike, runs in itertools.product((0.3, 0.6, 0.8), (0.0, 0.5, 0.8), (1, RUNS)):
        cells = [str(icc), str(alike), str(runs)]
        outlook = PowerAssumptions(_accuracy(SUITE), icc, alike, runs)
        for sizes in (SUITE, one):
            mine = replace(outlook, accuracy=_accuracy(sizes))
            gap = detectable_gap(*expected_error(sizes, mine))
            cells += [f"{100 * gap:.1f}", f"{_power(sizes, gap, mine, sims, rng):.0%}"]
        cells += [f"{_power(SUITE, 0.0, outlook, sims, rng):.1%}", f"{_needed(outlook):,}"]
        table.add_row(*cells)
    out.print(table)


def _accuracy(sizes: Mapping[str, int]) -> float:
    """The accuracy whose variance is the mean of that of these types."""
    spread = float(
        np.mean(
            [MIDDLING[question_type] * (1 - MIDDLING[question_type]) for question_type in sizes]
        )
    )
    return 0.5 + math.sqrt(0.25 - spread)


def _needed(outlook: PowerAssumptions, gap: float = 0.03) -> int:
    """Tasks of a suite with the shares of v1 that shows this difference."""
    times = (detectable_gap(*expected_error(SUITE, outlook)) / gap) ** 2
    return round(times * sum(SUITE.values()))


def _power(
    sizes: Mapping[str, int],
    gap: float,
    outlook: PowerAssumptions,
    sims: int,
    rng: np.random.Generator,
) -> float:
    """Share of suites in which the sign-flip test finds this difference at 5 %."""
    means = {
        question_type: (MIDDLING[question_type] + gap / 2, MIDDLING[question_type] - gap / 2)
        for question_type in sizes
    }
    alike = _joined(outlook)
    found = 0
    for _ in range(sims):
        one, other = map(strata_of, draw_units(rng, sizes, means, outlook.icc, alike, outlook.runs))
        differences = {
            question_type: one[question_type] - other[question_type] for question_type in sizes
        }
        found += no_difference_p(differences, rng, DRAWS) <= LEVEL
    return found / sims


def _joined(outlook: PowerAssumptions) -> Array:
    """How alike normal scores must be for chances to be as alike as assumed, shape (2, 2)."""

    def correlation(scores: float) -> float:
        alike = np.array([[1, scores], [scores, 1]])
        means = (outlook.accuracy, outlook.accuracy)
        chances = draw_chances(np.random.default_rng(0), means, outlook.icc, alike, 20_000)
        return float(np.corrcoef(chances)[0, 1])

    low, high = 0.0, 1.0
    while outlook.alike and high - low > 0.005:
        middle = (low + high) / 2
        low, high = (middle, high) if correlation(middle) < outlook.alike else (low, middle)
    return np.array([[1, low], [low, 1]])


def paper() -> None:
    """The paper's table with its averages worked out again."""
    columns = (
        "model",
        "arm",
        "printed",
        "macro",
        "pooled",
        "gain",
        "of averages",
        "of macro",
        "cells",
    )
    table = _table("The paper's Table 1, added up", *columns)
    for it in recount(printed_table()):
        row, mark = it.row, "" if it.follows else " (!)"
        gain = ["", "", ""]
        if row.gain is not None and it.gain is not None and it.macro_gain is not None:
            gain = [f"{row.gain:.1f}", f"{it.gain:.1f}", f"{it.macro_gain:.1f}"]
            gain[0] += "" if it.gain_follows else " (!)"
        averages = f"{row.average:.1f}{mark}", f"{it.macro:.2f}", f"{it.pooled:.2f}"
        table.add_row(row.model, row.setting, *averages, *gain, " ".join(it.unreachable))
    out.print(table)
    out.print("(!): rounding can't give it. Cells: no share of three runs of that many tasks.")
    cells = len(SUITE) * len(printed_table().rows)
    single = sum(len(it.single) for it in recount(printed_table()))
    out.print(f"{single} of {cells} cells are shares of single runs, as one in three would be.")
    for runs in (1, RUNS):
        p = setting_effect(_as_counts(runs), np.random.default_rng(0), draws=1).plain_p
        out.print(f"CMH of the table's cells with {runs} run(s) of each task: p = {p:.2g}")


def _as_counts(runs: int) -> dict[str, tuple[list[Unit], list[Unit]]]:
    """The table as episodes: a type is one task here, since its own are unknown."""
    models: dict[str, dict[str, list[Unit]]] = {}
    for row in printed_table().rows:
        for question_type, percent in row.percent.items():
            n = runs * SUITE[question_type]
            right = round(percent * n / 100)
            unit = Unit(question_type, question_type, (1.0,) * right + (0.0,) * (n - right))
            models.setdefault(row.model, {}).setdefault(row.setting, []).append(unit)
    return {model: (settings["agentic"], settings["direct"]) for model, settings in models.items()}


def _table(title: str, *columns: str) -> Table:
    table = Table(title=title, title_justify="left")
    for column in columns:
        table.add_column(column)
    return table


def main(sims: int = 200, seed: int = 0) -> None:
    """Print all tables.

    Args:
        sims: Suites of each line.
        seed: Of all draws.
    """
    rng = np.random.default_rng(seed)
    paper()
    coverage(sims, rng)
    false_alarms(sims, rng)
    gaps(sims, rng)


if __name__ == "__main__":
    tyro.cli(main)
