"""Verdicts by numbers that were worked out by other means."""

import pytest
from scipy import stats

from probe.shortcuts.findings import HitCount, allowed, detectable, judge
from probe.shortcuts.table import leaks, markdown


def hits(right: int, n: int, by: str = "rule", question_type: str = "find") -> HitCount:
    return HitCount(question_type, by, right, n, *allowed(question_type))


def test_the_rules_of_the_benchmark():
    assert allowed("find") == (0.20, 0.03)
    assert allowed("size") == allowed("compare") == (0.50, 0.04)
    assert allowed("count")[0] == pytest.approx(1 / 3)
    assert allowed("count", letters_alone=True) == (0.20, 0.03)


@pytest.mark.parametrize(
    ("right", "verdict"), [(60, "below"), (69, "below"), (70, "within noise"), (100, "above")]
)
def test_verdicts_of_a_single_test(right, verdict):
    (finding,) = judge([hits(right, 300)])
    assert finding.verdict == verdict
    assert finding.p == pytest.approx(stats.binom.sf(right - 1, 300, 0.2))


def test_wilson_by_hand():
    (finding,) = judge([hits(60, 300)])
    z, share, n = 1.959964, 0.2, 300
    centre = (share + z * z / (2 * n)) / (1 + z * z / n)
    half = z / (1 + z * z / n) * (share * (1 - share) / n + z * z / (4 * n * n)) ** 0.5
    assert (finding.low, finding.high) == pytest.approx((centre - half, centre + half), abs=1e-6)


def test_many_tests_make_luck_likelier():
    alone, *_ = judge([hits(78, 300)])
    assert alone.verdict == "above"
    among = judge([hits(78, 300), *[hits(60, 300)] * 100])
    assert among[0].verdict == "within noise"
    assert among[0].adjusted == pytest.approx(alone.p * 101)


def test_a_small_excess_is_no_leak_however_sure():
    (finding,) = judge([hits(2_200, 10_000)])
    assert finding.p < 1e-6 and finding.verdict == "below"


@pytest.mark.parametrize(("n", "tests"), [(300, 1), (300, 200), (1000, 200)])
def test_what_can_be_detected_is_called_in_four_of_five_sets(n, tests):
    share = detectable(n, 0.2, 0.03, tests)
    called = [k for k in range(n + 1) if stats.binom.sf(k - 1, n, 0.2) < 0.05 / tests]
    assert stats.binom.sf(called[0] - 1, n, share) == pytest.approx(0.8, abs=1e-6)


def test_what_is_within_the_limit_is_no_leak_however_many_tasks():
    # 23 % of 10,000 tasks is the limit; a share of 0.2336 exceeds it in four sets of five.
    share = detectable(10_000, 0.2, 0.03, 1)
    assert stats.binom.sf(2_300, 10_000, share) == pytest.approx(0.8, abs=1e-6)
    assert share == pytest.approx(0.2336, abs=2e-4)


def test_the_table_says_all_of_it():
    findings = judge(
        [hits(60, 300), hits(120, 300, "logistic on areas"), hits(20, 40, question_type="size")]
    )
    text = markdown(findings)
    assert text.startswith("3 tests: 2 below their limit, 0 over it within noise, 1 above it")
    assert "| logistic on areas | 40.0% | 300 |" in text and "**above**" in text
    assert text.index("### find") < text.index("### size")
    assert text.index("logistic on areas") < text.index("| rule | 20.0%")
    assert [finding.hits.by for finding in leaks(findings)] == ["logistic on areas"]
