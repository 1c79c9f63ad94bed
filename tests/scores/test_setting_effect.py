# An unexpected None fails a test as well as a check of its type does.
# pyright: reportOptionalMemberAccess=false, reportOptionalOperand=false, reportArgumentType=false, reportAttributeAccessIssue=false

import itertools

import numpy as np
import pytest
from statsmodels.stats.contingency_tables import StratifiedTable

from probe.scores.setting_effect import NoAgentInBothSettings, setting_effect
from probe.scores.units import Unit
from score_rows import unit, units

RNG = np.random.default_rng


def made(seed: int, tasks: int, runs: tuple[int, int], chances=(0.7, 0.4), agents=3):
    """Agents in two settings at tasks of two types."""
    rng = RNG(seed)
    names = [f"{question_type}-{i}" for question_type in ("find", "size") for i in range(tasks)]
    return {
        f"agent {k}": tuple(
            [unit(name, *map(float, rng.random(n) < chance)) for name in names]
            for n, chance in zip(runs, chances, strict=True)
        )
        for k in range(agents)
    }


def tables(both) -> list[np.ndarray]:
    """Setting by right or wrong, one table for each agent and type."""
    found = []
    for settings in both.values():
        for question_type in sorted({u.question_type for u in settings[0]}):
            runs = [
                [r for u in setting if u.question_type == question_type for r in u.runs]
                for setting in settings
            ]
            found.append(np.array([[sum(some), len(some) - sum(some)] for some in runs]))
    return found


@pytest.mark.parametrize("runs", [(1, 1), (3, 3), (3, 1)])
@pytest.mark.parametrize("seed", range(3))
def test_statistic_and_plain_p_as_statsmodels_has_them(seed, runs):
    both = made(seed, 5, runs)
    stratified = StratifiedTable(tables(both))
    expected = stratified.test_null_odds(correction=False)
    found = setting_effect(both, RNG(0), draws=99)
    assert found.statistic == pytest.approx(expected.statistic)
    assert found.plain_p == pytest.approx(expected.pvalue)
    assert found.odds_ratio == pytest.approx(stratified.oddsratio_pooled)
    assert (found.agents, found.tasks, found.left_out) == (3, 10, 0)
    assert found.episodes == 3 * 10 * sum(runs)


@pytest.mark.parametrize("runs", [(2, 2), (3, 1)])
def test_p_is_the_share_of_all_swaps_of_whole_tasks(runs):
    both = made(4, 4, runs, agents=2)
    names = [u.task for u in next(iter(both.values()))[0]]
    statistics = []
    for swap in itertools.product((False, True), repeat=len(names)):
        swapped = dict(zip(names, swap, strict=True))
        way = {
            agent: ([b if swapped[a.task] else a for a, b in zip(*settings, strict=True)],
                    [a if swapped[a.task] else b for a, b in zip(*settings, strict=True)])
            for agent, settings in both.items()
        }  # fmt: skip
        # Where a type's answers are all right or all wrong, statsmodels divides 0 by 0.
        kept = [t for t in tables(way) if t.sum(axis=0).all()]
        statistics.append(StratifiedTable(kept).test_null_odds(correction=False).statistic)
    expected = np.mean(np.array(statistics) >= statistics[0] - 1e-9)
    found = setting_effect(both, RNG(0))
    assert found.p == pytest.approx(expected)
    assert 0 < found.p < 1


def test_one_task_by_hand():
    # Right 2 of 2 against 0 of 2: a = 2, E = 1, Var = 2 * 2 * 2 * 2 / (16 * 3) = 1/3.
    found = setting_effect({"anna": ([unit("find-1", 1, 1)], [unit("find-1", 0, 0)])}, RNG(0))
    assert found.statistic == pytest.approx(3)
    assert found.p == 1
    assert found.odds_ratio is None  # infinite


def test_all_agents_of_a_task_are_swapped_at_once():
    # Ten agents gain at the same two tasks of a type: 2 of 4 ways are that far off, not 2 of 2^20.
    both = {f"a{k}": (units("find", 1, 1), units("find", 0, 0)) for k in range(10)}
    found = setting_effect(both, RNG(0))
    assert found.p == 0.5
    assert found.plain_p < 1e-4


@pytest.mark.parametrize("worth", [0, 1])
def test_nothing_varies(worth):
    same = units("find", worth, worth)
    found = setting_effect({"anna": (same, same)}, RNG(0))
    assert (found.statistic, found.p, found.plain_p, found.odds_ratio) == (0, 1, 1, None)


def test_tasks_of_one_arm_alone_are_left_out_and_counted():
    anna = ([unit("find-1", 1), unit("find-2", 1)], [unit("find-1", 0), unit("find-3", 1)])
    bob = ([unit("find-9", 1)], [unit("find-8", 1)])
    found = setting_effect({"anna": anna, "bob": bob}, RNG(0))
    assert (found.agents, found.tasks, found.episodes, found.left_out) == (1, 1, 2, 4)
    with pytest.raises(
        NoAgentInBothSettings,
        match=r"^No agent has a task in both settings. Run at least one agent in both\.$",
    ):
        setting_effect({"bob": bob}, RNG(0))
    with pytest.raises(NoAgentInBothSettings):
        setting_effect({}, RNG(0))


def test_agents_need_not_share_their_tasks():
    both = {
        "anna": (units("find", 1, 1, 0), units("find", 0, 1, 0)),
        "bob": ([Unit("find-7", "find", (1.0,))], [Unit("find-7", "find", (0.0,))]),
    }
    found = setting_effect(both, RNG(0))
    expected = StratifiedTable([np.array([[2, 1], [1, 2]]), np.array([[1, 0], [0, 1]])])
    assert found.statistic == pytest.approx(expected.test_null_odds().statistic)
    assert (found.agents, found.tasks) == (2, 4)


def test_draws_come_near_to_all_swaps():
    both = made(6, 6, (3, 3), chances=(0.55, 0.45))
    exact = setting_effect(both, RNG(0)).p
    drawn = setting_effect(both, RNG(0), draws=4000).p
    assert drawn * 4001 == pytest.approx(round(drawn * 4001))
    assert exact * 2**12 == round(exact * 2**12)
    assert drawn == pytest.approx(exact, abs=4 * np.sqrt(exact * (1 - exact) / 4000))


def test_the_better_arm_has_odds_over_one():
    better = setting_effect(made(1, 9, (3, 3)), RNG(0), draws=99)
    worse = setting_effect(
        {k: (b, a) for k, (a, b) in made(1, 9, (3, 3)).items()}, RNG(0), draws=99
    )
    assert better.odds_ratio is not None and worse.odds_ratio is not None
    assert better.odds_ratio > 1 > worse.odds_ratio
    assert better.odds_ratio == pytest.approx(1 / worse.odds_ratio)
    assert better.statistic == pytest.approx(worse.statistic)
