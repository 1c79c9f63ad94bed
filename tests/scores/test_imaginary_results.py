"""Imaginary agents are what they are said to be, and the statistics hold on them."""

import numpy as np
import pytest
from scipy import stats

from imaginary_results import draw_chances, draw_units, two_settings
from probe.scores.intervals import bootstrap, student
from probe.scores.pairs import no_difference_p
from probe.scores.power import PowerAssumptions, detectable_gap, expected_error
from probe.scores.scorecard import icc
from probe.scores.setting_effect import setting_effect
from probe.scores.units import strata_of

RNG = np.random.default_rng
SIZES = {"find": 14, "size": 12, "count": 10}
MIDDLING = {"find": 0.7, "size": 0.6, "count": 0.4}


def test_chances_have_the_mean_and_the_correlation_that_were_asked_for():
    alike = np.array([[1.0, 0.5], [0.5, 1.0]])
    chances = draw_chances(RNG(1), [0.7, 0.3], 0.4, alike, 40_000)
    assert chances.shape == (2, 40_000)
    assert chances.mean(axis=1) == pytest.approx([0.7, 0.3], abs=0.006)
    # The variance of chances is the ICC's share of p (1 - p).
    assert chances.var(axis=1) == pytest.approx([0.4 * 0.21] * 2, rel=0.03)
    # Ranks of two normal numbers have the correlation 6 / pi asin(r / 2) (Pearson, 1907).
    ranks = stats.spearmanr(chances[0], chances[1]).statistic
    assert ranks == pytest.approx(6 / np.pi * np.arcsin(0.25), abs=0.02)


@pytest.mark.parametrize("asked", [0.1, 0.5, 0.9])
def test_runs_resemble_each_other_as_asked(asked):
    sizes, means = {"find": 9000, "size": 300}, {"find": [0.6], "size": [0.2]}
    (units,) = draw_units(RNG(2), sizes, means, asked, np.eye(1), 3)
    assert icc(units) == pytest.approx(asked, abs=0.03)
    assert [len(unit.runs) for unit in units] == [3] * 9300
    assert units[0].task == "find-0"
    assert set(units[0].runs) <= {0.0, 1.0}


def test_two_arms_by_hand():
    # Agents a, b in one setting, then in the other.
    expected = [
        [1.0, 0.3, 0.4, 0.2],
        [0.3, 1.0, 0.2, 0.4],
        [0.4, 0.2, 1.0, 0.3],
        [0.2, 0.4, 0.3, 1.0],
    ]
    assert two_settings(2, task=0.2, agent=0.2, setting=0.1) == pytest.approx(np.array(expected))


def test_intervals_hold_the_truth():
    rng, truth = RNG(3), np.mean(list(MIDDLING.values()))
    held, sims = np.zeros(2), 800
    for _ in range(sims):
        means = {question_type: [value] for question_type, value in MIDDLING.items()}
        strata = strata_of(draw_units(rng, SIZES, means, 0.6, np.eye(1), 3)[0])
        found = student(strata), bootstrap(strata, 0, draws=500)
        held += [it.low <= truth <= it.high for it in found]
    # The standard error of a share of 0.95 is 0.8 points; percentiles are a little narrow.
    assert 0.93 < held[0] / sims < 0.97
    assert 0.92 < held[1] / sims < 0.97


def test_plain_cmh_cries_wolf_where_swapped_tasks_do_not():
    rng, alarms, sims = RNG(4), np.zeros(2), 400
    alike = two_settings(4, task=0.0, agent=0.0, setting=0.25)
    means = {question_type: [value] * 8 for question_type, value in MIDDLING.items()}
    for _ in range(sims):
        entrants = draw_units(rng, SIZES, means, 0.6, alike, 3)
        both = {f"agent {k}": (entrants[k], entrants[4 + k]) for k in range(4)}
        found = setting_effect(both, rng, draws=199)
        alarms += (found.plain_p <= 0.05, found.p <= 0.05)
    assert alarms[0] / sims > 0.15
    # At most 5 %, give or take three standard errors of 1.1 points.
    assert alarms[1] / sims < 0.085


def test_four_in_five_suites_show_the_detectable_gap_and_few_show_none():
    rng, sims = RNG(5), 600
    # The accuracy whose variance is the mean of that of the three types.
    spread = np.mean([value * (1 - value) for value in MIDDLING.values()])
    outlook = PowerAssumptions(0.5 + np.sqrt(0.25 - spread), icc=0.5, alike=0.5, runs=3)
    gap = detectable_gap(*expected_error(SIZES, outlook))
    alike = np.array([[1.0, 0.5], [0.5, 1.0]])
    found = np.zeros(2)
    for _ in range(sims):
        for place, apart in enumerate((gap, 0.0)):
            means = {k: (value + apart / 2, value - apart / 2) for k, value in MIDDLING.items()}
            one, other = map(strata_of, draw_units(rng, SIZES, means, 0.5, alike, 3))
            differences = {
                question_type: one[question_type] - other[question_type] for question_type in SIZES
            }
            found[place] += no_difference_p(differences, rng, draws=299) <= 0.05
    assert 0.73 < found[0] / sims < 0.87
    assert found[1] / sims < 0.08
