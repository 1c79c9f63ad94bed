# An unexpected None fails a test as well as a check of its type does.
# pyright: reportOptionalMemberAccess=false, reportOptionalOperand=false, reportArgumentType=false

from itertools import combinations

import numpy as np
import pytest
from scipy import stats
from statsmodels.stats.multitest import multipletests

from probe.scores.pairs import NothingShared, family
from probe.scores.row import Entrant
from score_rows import unit, units

ANNA, BOB, CARL = Entrant("anna", "agentic"), Entrant("bob", "agentic"), Entrant("carl", "direct")


SHARE_NOTHING = (
    r"^anna \(agentic\) and carl \(direct\) share no task\. "
    r"Compare those that ran the same suite\.$"
)


def test_one_type_by_hand():
    results = {ANNA: units("find", 1, 1, 1, 0), BOB: units("find", 0, 0, 1, 0)}
    (pair,) = family(results, [(ANNA, BOB)], seed=0)
    assert (pair.first, pair.second, pair.tasks, pair.left_out) == (ANNA, BOB, 4, 0)
    assert pair.difference == pytest.approx(0.5)
    assert pair.question_types == {"find": 0.5}
    # Two tasks differ, both the same way: 2 of 4 signs are as far from 0.
    assert pair.p == pair.adjusted == 0.5
    assert pair.tie
    low, high = stats.t.interval(0.95, 3, 0.5, stats.sem([1, 1, 0, 0]))
    assert pair.student.low == pytest.approx(low)
    assert pair.student.high == pytest.approx(min(1, high))
    assert -0.1 < pair.bootstrap.low < 0.5 < pair.bootstrap.high <= 1.0
    gap = (stats.t.ppf(0.975, 3) + stats.t.ppf(0.8, 3)) * stats.sem([1, 1, 0, 0])
    assert pair.detectable == pytest.approx(gap)


def test_types_weigh_alike():
    anna = [*units("find", 1), *units("size", 0, 0, 0, 1)]
    bob = [*units("find", 0), *units("size", 1, 0, 0, 1)]
    (pair,) = family({ANNA: anna, BOB: bob}, [(ANNA, BOB)], seed=0)
    assert pair.difference == pytest.approx((1 - 0.25) / 2)
    assert pair.question_types == {"find": 1.0, "size": -0.25}
    # Of the four signs of 1/2 and -1/8, those that agree are further from 0: all four count.
    assert pair.p == 1.0
    (pair,) = family(
        {ANNA: anna, BOB: [*bob[:1], *units("size", 0, 0, 0, 0)]}, [(ANNA, BOB)], seed=0
    )
    assert pair.p == 0.5  # 1/2 and 1/8


def test_p_weighs_types_alike_too():
    anna = [*units("find", 1), *units("size", 1, 0, 0, 0)]
    bob = [*units("find", 0), *units("size", 0, 1, 1, 1)]
    (pair,) = family({ANNA: anna, BOB: bob}, [(ANNA, BOB)], seed=0)
    # Found is 1 - 2/4. Of the 32 ways +-1 + s, s is 1 or -1 once each, 1/2 or -1/2 four times and
    # 0 six times: only the two ways to make 0 are nearer to 0 than 1/2.
    assert pair.difference == 0.25
    assert pair.p == 30 / 32


def test_a_level_is_passed_on():
    results = {ANNA: units("find", 1, 1, 0, 0, 0, 1, 1, 1), BOB: units("find", *[0] * 8)}
    (wide,), (narrow,) = (family(results, [(ANNA, BOB)], 0, level=it) for it in (0.99, 0.5))
    assert wide.student.low < narrow.student.low
    assert wide.bootstrap.low < narrow.bootstrap.low
    assert wide.p == narrow.p == 2 / 32
    assert (wide.tie, narrow.tie) == (True, False)


def test_a_worse_agent_has_a_difference_below_zero():
    (pair,) = family({ANNA: units("find", 0, 0), BOB: units("find", 1, 1)}, [(ANNA, BOB)], seed=0)
    assert pair.difference == -1
    assert pair.bootstrap.low == pair.student.low == -1
    assert pair.bootstrap.high == pair.student.high < 0.5


def test_only_shared_tasks_count_and_the_rest_is_counted():
    anna = [unit("find-1", 1), unit("find-2", 0, 1), unit("find-3", 1), unit("size-1", 1)]
    bob = [unit("find-2", 0), unit("find-3", 0), unit("find-4", 1)]
    (pair,) = family({ANNA: anna, BOB: bob}, [(ANNA, BOB)], seed=0)
    assert (pair.tasks, pair.left_out, pair.difference) == (2, 3, 0.75)
    assert list(pair.question_types) == ["find"]


def test_nothing_shared_is_refused():
    with pytest.raises(NothingShared, match=SHARE_NOTHING):
        family({ANNA: [unit("find-1", 1)], CARL: [unit("find-2", 1)]}, [(ANNA, CARL)], seed=0)


def test_a_family_is_corrected_for_its_size_as_statsmodels_has_it():
    rng = np.random.default_rng(2)
    results = {
        who: [
            *units("find", *rng.binomial(3, chance, 12) / 3),
            *units("size", *rng.binomial(3, chance, 7) / 3),
        ]
        for who, chance in ((ANNA, 0.7), (BOB, 0.6), (CARL, 0.2))
    }
    found = family(results, combinations(results, 2), seed=0)
    chances = [pair.p for pair in found]
    rejected, adjusted, *_ = multipletests(chances, method="holm")
    assert [pair.adjusted for pair in found] == pytest.approx(list(adjusted))
    assert [not pair.tie for pair in found] == list(rejected)
    assert len(set(rejected)) == 2  # both happen


def test_p_is_that_of_scipys_permutation_test_within_types():
    rng = np.random.default_rng(8)
    a, b = rng.binomial(3, 0.8, 9) / 3, rng.binomial(3, 0.5, 9) / 3
    c, d = rng.binomial(3, 0.7, 5) / 3, rng.binomial(3, 0.5, 5) / 3
    anna, bob = ([*units("find", *x), *units("size", *y)] for x, y in ((a, c), (b, d)))
    (pair,) = family({ANNA: anna, BOB: bob}, [(ANNA, BOB)], seed=0)
    weighted = np.concatenate([(a - b) / 9 / 2, (c - d) / 5 / 2])
    expected = stats.permutation_test(
        (weighted,), sum, permutation_type="samples", vectorized=False, n_resamples=10**9
    ).pvalue
    assert pair.p == pytest.approx(expected)


def test_the_two_sides_may_be_exchanged():
    rng = np.random.default_rng(3)
    results = {who: units("find", *rng.binomial(3, 0.5, 11) / 3) for who in (ANNA, BOB)}
    (one,), (other,) = (family(results, [pair], seed=0) for pair in ((ANNA, BOB), (BOB, ANNA)))
    assert one.difference == -other.difference
    assert one.p == other.p
    assert one.student.low == pytest.approx(-other.student.high)


def test_twins_are_a_tie():
    same = units("find", 1, 0, 1 / 3)
    (pair,) = family({ANNA: same, BOB: same}, [(ANNA, BOB)], seed=0)
    assert (pair.difference, pair.p, pair.tie, pair.detectable) == (0, 1, True, None)
    assert pair.student.low < 0 < pair.student.high


def test_one_task():
    (pair,) = family({ANNA: units("find", 1), BOB: units("find", 0)}, [(ANNA, BOB)], seed=0)
    assert (pair.difference, pair.p, pair.tie) == (1, 1, True)


def test_draws_depend_on_seed_and_pair_alone():
    rng = np.random.default_rng(5)
    results = {
        who: units("find", *rng.binomial(3, p, 60) / 3) for who, p in ((ANNA, 0.6), (BOB, 0.5))
    }
    results[CARL] = results[BOB]
    one = family(results, [(ANNA, BOB)], seed=1, draws=999)[0].p
    assert (one * 1000) % 1 == pytest.approx(0, abs=1e-9)
    assert family(results, [(ANNA, CARL), (ANNA, BOB)], seed=1, draws=999)[1].p == one
    others = {family(results, [(ANNA, BOB)], seed=seed, draws=999)[0].p for seed in range(2, 8)}
    assert len(others | {one}) > 1
    assert family(results, [(ANNA, CARL)], seed=1, draws=999)[0].p == pytest.approx(one, abs=0.06)


def test_no_pairs_no_family():
    assert family({}, [], seed=0) == []
