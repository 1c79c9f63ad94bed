"""`probe report sim-real` on three agents, its numbers recomputed with fractions."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import permutations, product
from pathlib import Path

import pytest

from pages import Page
from probe.api.sim_real import write_sim_real
from probe.cli.sim_real import sim_real
from probe.episodes.files import line_of
from probe.episodes.tool_errors import HEADLINE
from probe.errors import BadData
from probe.scores.row import Entrant
from probe.tasks.headline import HeadlineErrors
from probe.tasks.task import Task
from run_folders import DEMO, episode, on_robot, write_run

TASKS = [task for task in DEMO.tasks if task.question_type != "find"]
"""Two of Beneath, then two of Count."""

Results = Mapping[str, Sequence[str]]

SIM: Results = {
    "scripted": ("111", "110", "111", "111"),
    "random": ("000", "100", "000", "010"),
    "hasty": ("000", "010", "111", "110"),
}
"""Of each agent, for each task, its runs; hasty never moves what covers something."""

REAL: Results = {
    "scripted": ("101", "100", "110", "111"),
    "random": ("010", "000", "000", "100"),
    "hasty": ("000", "000", "110", "011"),
}


def folder(
    path: Path,
    results: Results,
    tasks: Sequence[Task],
    *,
    real: bool,
    name: str = "demo",
    headline: HeadlineErrors | None = None,
) -> Path:
    records = [
        episode(task, agent=agent, run=run, right=it == "1")
        for agent, each in results.items()
        for task, runs in zip(tasks, each, strict=True)
        for run, it in enumerate(runs)
    ]
    made = [on_robot(it, path) for it in records] if real else records
    suite = replace(DEMO, name=name, tasks=tuple(tasks), headline=headline)
    return write_run(path, made, suite, pictures=False)


def success(runs: Sequence[str], chosen: Sequence[int] = (0, 1, 2, 3)) -> Fraction:
    """Runs to tasks, tasks to types, types to one number."""
    tasks = [Fraction(each.count("1"), len(each)) for each in runs]
    beneath, count = chosen[:2], chosen[2:]
    return sum((tasks[it] / 4 for it in (*beneath, *count)), Fraction(0))


def r_of(x: Sequence[Fraction | float], y: Sequence[Fraction | float]) -> float:
    top = 3 * sum(a * b for a, b in zip(x, y, strict=True)) - sum(x) * sum(y)
    below = [3 * sum(a * a for a in row) - sum(row) ** 2 for row in (x, y)]
    return float(top) / math.sqrt(below[0] * below[1])


def ranks(x: Sequence[Fraction | float]) -> list[Fraction]:
    return [
        Fraction(2 * sum(other < mine for other in x) + sum(other == mine for other in x) + 1, 2)
        for mine in x
    ]


def widened(chosen: Sequence[int]) -> list[list[float]]:
    """Both sides drawn so; what two tasks deviate from their mean by is widened by sqrt(2)."""
    return [
        [float(mean) + math.sqrt(2) * float(one - mean) for one, mean in zip(*both, strict=True)]
        for both in zip(both_sides(chosen), both_sides(), strict=True)
    ]


def both_sides(chosen: Sequence[int] = (0, 1, 2, 3)) -> list[list[Fraction]]:
    return [[success(side[agent], chosen) for agent in SIM] for side in (SIM, REAL)]


def test_three_agents_as_computed_by_hand(tmp_path: Path) -> None:
    sim, real = (
        folder(tmp_path / name, results, TASKS, real=name == "real")
        for name, results in (("sim", SIM), ("real", REAL))
    )
    found = write_sim_real(sim, real, tmp_path / "out")
    assert found.tasks == tuple(sorted(task.id for task in TASKS)) and not found.tasks_left_out
    # Of the table above: 11/12, 1/6 and 1/2 in simulation, 2/3, 1/6 and 1/3 on the robot.
    x, y = both_sides()
    assert x == [Fraction(11, 12), Fraction(1, 6), Fraction(1, 2)]
    assert y == [Fraction(2, 3), Fraction(1, 6), Fraction(1, 3)]
    assert [it.entrant.agent for it in found.agents] == ["scripted", "hasty", "random"]
    for it in found.agents:
        mine = list(SIM).index(it.entrant.agent)
        assert it.sim.success == pytest.approx(float(x[mine]))
        assert it.real.success == pytest.approx(float(y[mine]))
        assert it.difference.difference == pytest.approx(float(y[mine] - x[mine]))
        assert it.sim.interval.low <= it.sim.success <= it.sim.interval.high
        assert it.sim.runs == it.real.runs == 12
        assert sum(it.real.causes.values()) == sum(r.count("0") for r in REAL[it.entrant.agent])
    for agreement, how in (
        (found.pearson, lambda a, b: r_of(a, b)),
        (found.spearman, lambda a, b: r_of(ranks(a), ranks(b))),
    ):
        assert agreement.value == pytest.approx(how(x, y), abs=1e-12)
        as_good = sum(how(x, order) >= how(x, y) - 1e-12 for order in permutations(y))
        assert agreement.p == pytest.approx(as_good / 6)
        # Two tasks of a type are drawn in 4 ways, so that each of 16 draws has 6.25 %: more than
        # either tail, and the interval reaches from the least to the largest.
        draws = [how(*widened(d)) for d in product((0, 1), (0, 1), (2, 3), (2, 3))]
        assert agreement.over_tasks is not None
        assert agreement.over_tasks.low == pytest.approx(min(draws), abs=1e-9)
        assert agreement.over_tasks.high == pytest.approx(max(draws), abs=1e-9)
        assert agreement.undefined == 0
    assert found.pearson.over_models is not None and found.spearman.over_models is None


def test_the_page_says_what_it_rests_on(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    sim = folder(tmp_path / "sim", SIM, TASKS, real=False)
    real = folder(tmp_path / "real", REAL, TASKS, real=True)
    sim_real(sim, real, tmp_path / "out")
    page = Page((tmp_path / "out" / "index.html").read_text())
    (top,) = page.all("header")
    assert "Agents have the same order in both places. 4 tasks are too few to tell" in top.text
    assert "perception segmenter" in top.text and "perception oracle" in top.text
    agreement = page.section("agreement")
    assert "Correlation over 3 models" in agreement and "They can't show" in agreement
    assert "in 1 of 6 cases" in agreement and "0.997" in agreement
    assert len(page.all("circle")) == 3
    assert "wrong, nothing moved" not in page.section("causes")
    assert "wrong, things moved" in page.section("causes")
    data = json.loads((tmp_path / "out" / "sim-real.json").read_text())
    assert data["pearson"]["value"] == pytest.approx(r_of(*both_sides()))
    assert "Spearman's rho = 1.000" in capsys.readouterr().out


def test_what_both_places_dont_share_is_named(tmp_path: Path) -> None:
    """A task of one place alone, one that changed, one that an agent lacks, and an agent."""
    sim = folder(tmp_path / "sim", SIM, TASKS, real=False)
    changed = replace(TASKS[1], seed=TASKS[1].seed + 1)
    less = {"scripted": ("1", "1", "1"), "random": ("0", "0", "1"), "slow": ("0", "1", "0")}
    real = folder(tmp_path / "real", less, [TASKS[0], changed, TASKS[2]], real=True, name="laid")
    broken = on_robot(episode(TASKS[2], agent="hasty", fault="RobotLost: gone"), real)
    first = on_robot(episode(TASKS[0], agent="hasty"), real)
    with (real / "records.jsonl").open("ab") as file:
        file.writelines(line_of(it) for it in (broken, first))
    found = write_sim_real(sim, real, tmp_path / "out")
    assert found.tasks == (TASKS[0].id,)
    assert found.tasks_left_out == {
        TASKS[1].id: "it differs between the suites",
        TASKS[2].id: "hasty has no result on the robot",
        TASKS[3].id: "it isn't in the robot's suite",
    }
    hasty = next(it for it in found.agents if it.entrant.agent == "hasty")
    assert hasty.real.interrupted == 1  # at a task that isn't compared
    # One task of a type tells nothing of others.
    assert found.pearson.over_tasks is None
    slow = Entrant("slow", "agentic")
    assert found.agents_left_out == {slow: "isn't there in simulation"}
    page = Page((tmp_path / "out" / "index.html").read_text()).section("left-out")
    assert "1 task, since hasty has no result on the robot" in page and "slow" in page


def test_conditions_apart_from_the_headline_are_not_the_agents(tmp_path: Path) -> None:
    sim, real = (
        folder(tmp_path / name, results, TASKS, real=name == "real", headline=HEADLINE)
        for name, results in (("sim", SIM), ("real", REAL))
    )
    found = write_sim_real(sim, real, tmp_path / "out")
    assert {it.entrant.agent for it in found.agents} == {*SIM} and not found.agents_left_out
    top = Page((tmp_path / "out" / "index.html").read_text()).all("header")[0].text
    assert "ideal hand" in top and "perception segmenter" in top


def test_two_folders_of_simulation_are_refused(tmp_path: Path) -> None:
    sim = folder(tmp_path / "sim", SIM, TASKS, real=False)
    with pytest.raises(BadData, match="has records of simulation"):
        write_sim_real(sim, sim, tmp_path / "out")
