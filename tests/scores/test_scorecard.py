# An unexpected None fails a test as well as a check of its type does.
# pyright: reportOptionalMemberAccess=false, reportOptionalOperand=false, reportArgumentType=false

import math

# An unexpected None fails a test as well as a check of its type does.
# pyright: reportOptionalMemberAccess=false, reportOptionalOperand=false, reportArgumentType=false
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy import stats
from statsmodels.stats.proportion import proportion_confint

from probe.scores.missing import Gap, Headline
from probe.scores.roster import Listed
from probe.scores.scorecard import icc, scorecard
from probe.scores.units import ContraryRows, Unit
from score_rows import faulty, roster, row, unit

SHROUT_FLEISS = [
    [9, 2, 5, 8],
    [6, 1, 3, 2],
    [8, 4, 6, 8],
    [7, 1, 2, 6],
    [10, 5, 6, 9],
    [6, 2, 4, 7],
]
"""Six targets, four ratings each: table 2 of Psychol. Bull. 86(2), 1979; ICC(1, 1) is .17."""


def published(question_type: str = "find"):
    return [
        Unit(f"{question_type}-{i}", question_type, tuple(map(float, runs)))
        for i, runs in enumerate(SHROUT_FLEISS)
    ]


def test_the_published_example():
    found = icc(published())
    assert found == pytest.approx(0.17, abs=0.005)
    # Mean squares of their table 3: 11.24 between targets, 6.26 within.
    assert found == pytest.approx((11.2417 - 6.2639) / (11.2417 + 3 * 6.2639), abs=1e-4)


def test_types_are_pooled_by_their_mean_squares_and_their_means_play_no_part():
    shifted = [
        Unit(u.task, u.question_type, tuple(r + 100 for r in u.runs)) for u in published("size")
    ]
    assert icc([*published(), *shifted]) == pytest.approx(icc(published()))


def test_runs_that_always_agree():
    assert icc([unit("find-1", 1, 1, 1), unit("find-2", 0, 0, 0)]) == pytest.approx(1)


def test_by_hand_below_zero():
    # Between 0, within 2 * 0.5 / 2 = 0.5: (0 - 0.5) / (0 + 0.5).
    assert icc([unit("find-1", 1, 0), unit("find-2", 0, 1)]) == pytest.approx(-1)


def test_unequal_runs_by_hand():
    # Runs (1, 1, 0), (0,): mean 0.5; between = 3 (2/3 - 1/2)^2 + (0 - 1/2)^2 = 1/3 on 1 degree;
    # within = 2/3 on 2 degrees; runs a task = 4 - (9 + 1) / 4 = 1.5 on 1 degree.
    found = icc([unit("find-1", 1, 1, 0), unit("find-2", 0)])
    assert found == pytest.approx((1 / 3 - 1 / 3) / (1 / 3 + 0.5 / 3), abs=1e-12)
    # Runs (1, 1, 1), (0,): within 0 gives 1 whatever the rest.
    assert icc([unit("find-1", 1, 1, 1), unit("find-2", 0)]) == pytest.approx(1)
    # Runs (1, 1), (0, 1, 0, 0), (0,): N = 7, mean 3/7; between = 2 (4/7)^2 + 4 (1/4 - 3/7)^2
    # + (3/7)^2 = 54/56 on 2; within = 3/4 on 4; runs = (7 - (4 + 16 + 1) / 7) / 2 = 2.
    between, within = 54 / 56 / 2, 3 / 16
    found = icc([unit("find-1", 1, 1), unit("find-2", 0, 1, 0, 0), unit("find-3", 0)])
    assert found == pytest.approx((between - within) / (between + within))


@pytest.mark.parametrize(
    "units",
    [
        [],
        [unit("find-1", 1, 0)],  # one task
        [unit("find-1", 1, 0), unit("size-1", 0, 0)],  # one task a type
        [unit("find-1", 1), unit("find-2", 0)],  # one run
        [unit("find-1", 1, 1), unit("find-2", 1, 1)],  # nothing varies
    ],
)
def test_nothing_to_tell_it_from(units):
    assert icc(units) is None


def test_a_type_of_one_task_says_something_of_the_luck_of_runs():
    # Within: (2 * 0.25 + 0 + 0) / 3; between 1 on 1 degree from the other type, 2 runs a task.
    found = icc([unit("size-1", 1, 0), unit("find-1", 1, 1), unit("find-2", 0, 0)])
    within = 0.5 / 3
    assert found == pytest.approx((1 - within) / (1 + within))


@given(
    st.lists(st.lists(st.sampled_from([0.0, 1.0]), min_size=3, max_size=3), min_size=2, max_size=9)
)
def test_equal_runs_as_the_analysis_of_variance_gives_it(runs):
    found = icc([Unit(f"find-{i}", "find", tuple(it)) for i, it in enumerate(runs)])
    table = np.array(runs)
    between = 3 * table.mean(axis=1).var(ddof=1)
    within = table.var(axis=1, ddof=1).mean()
    if between + within == 0:
        assert found is None
    else:
        assert found == pytest.approx((between - within) / (between + 2 * within))


ROSTER = {
    **roster("find-1", "find-2", stratum="hidden"),
    **roster("find-3", stratum="partly"),
    **roster("size-1", "size-2", options=2),
}


def rows(run: int = 0):
    missed = {"answer": "B", "letter_correct": True, "outcome": "missed"}
    return [
        row("find-1", True, stratum="hidden", run=run),
        row("find-2", False, stratum="hidden", run=run, **missed),
        row("find-3", False, stratum="partly", run=run),
        row("size-1", True, options=2, run=run, manipulations=0, manipulated=False),
        row("size-2", False, options=2, run=run),
    ]


def test_figures_of_a_whole_run():
    card = scorecard(rows(), ROSTER, seed=0)
    assert card.entrant == ("anna", "agentic")
    # Find 1 of 3, Size 1 of 2; chance 0.2 and 0.5.
    assert (card.macro.name, card.macro.headline.value) == ("macro", pytest.approx(5 / 12))
    assert card.macro.chance == pytest.approx(0.35)
    assert card.macro.corrected == pytest.approx((5 / 12 - 0.35) / 0.65)
    assert (card.macro.tasks, card.macro.runs, card.macro.wilson) == (5, 5, None)
    find, size = card.question_types
    assert (find.name, size.name) == ("find", "size")
    assert find.headline == Headline(
        pytest.approx(1 / 3), pytest.approx(1 / 3), pytest.approx(1 / 3), 3, 0
    )
    assert (size.headline.value, size.chance, size.corrected) == (0.5, 0.5, 0)
    letter, hidden, partly = card.parts
    assert (letter.name, letter.headline.value) == ("find, letter alone", pytest.approx(2 / 3))
    assert (hidden.name, hidden.headline.value, hidden.tasks) == ("find, hidden", 0.5, 2)
    assert (partly.name, partly.headline.value, partly.chance) == ("find, partly", 0, 0.2)
    assert (card.gaps, card.icc, card.execution) == ((), None, None)
    assert [(it.question_type, it.unused_right) for it in card.outcomes] == [
        ("find", 0),
        ("size", 1),
    ]
    assert card.effort.episodes == 5


def test_beyond_chance_is_reckoned_from_the_naive_ceiling():
    some = [row("count-1", True), row("count-2", False), row("beneath-1", True)]
    card = scorecard(some, roster("count-1", "count-2", "beneath-1"), seed=0)
    beneath, count = card.question_types
    assert (count.headline.value, count.chance, count.naive) == (0.5, 0.2, pytest.approx(1 / 3))
    # (1/2 - 1/5) / (4/5), and (1/2 - 1/3) / (2/3).
    assert count.beyond_guessing == pytest.approx(3 / 8)
    assert count.corrected == pytest.approx(1 / 4)
    assert (beneath.naive, beneath.corrected, beneath.beyond_guessing) == (0.2, 1, 1)
    # Macro 3/4; guessing 1/5, naive (1/5 + 1/3) / 2 = 4/15.
    assert card.macro.beyond_guessing == pytest.approx(11 / 16)
    assert card.macro.corrected == pytest.approx(29 / 44)


def test_intervals_of_single_runs():
    find = scorecard(rows(), ROSTER, seed=0).question_types[0]
    low, high = proportion_confint(1, 3, method="wilson")
    assert (find.wilson.low, find.wilson.high) == pytest.approx((low, high))
    t = stats.t.interval(0.95, 2, 1 / 3, stats.sem([1, 0, 0]))
    assert (find.student.low, find.student.high) == (max(0, t[0]), min(1, t[1]))
    assert 0 <= find.bootstrap.low < 1 / 3 < find.bootstrap.high <= 1


def test_the_letter_has_intervals_of_its_own():
    letter = scorecard(rows(), ROSTER, seed=0).parts[0]
    low, high = proportion_confint(2, 3, method="wilson")
    assert (letter.wilson.low, letter.wilson.high) == pytest.approx((low, high))


def test_execution_is_on_the_card():
    done = row("reduce-1", recall=0.5, exact=False, others_disturbed=0, strict=False)
    card = scorecard([done], roster("reduce-1"), seed=0)
    assert (card.execution.episodes, card.execution.recall) == (1, 0.5)


def test_wilson_is_kept_from_several_runs():
    card = scorecard([*rows(0), *rows(1)], ROSTER, seed=0)
    assert all(it.wilson is None for it in (*card.question_types, *card.parts))
    assert card.icc == pytest.approx(1)
    assert card.macro.runs == 10
    assert card.question_types[0].headline.rows == 6


def test_the_detectable_difference_is_from_an_unrelated_equal():
    card = scorecard(rows(), ROSTER, seed=0)
    # Variances 1/3 of three and 1/2 of two tasks, halved weights.
    parts = [1 / 3 / 3 / 4, 1 / 2 / 2 / 4]
    freedom = sum(parts) ** 2 / (parts[0] ** 2 / 2 + parts[1] ** 2 / 1)
    quantiles = stats.t.ppf(0.975, freedom) + stats.t.ppf(0.8, freedom)
    assert card.detectable == pytest.approx(quantiles * math.sqrt(2 * sum(parts)))


def test_an_incomplete_run_shows_bounds_and_no_number():
    some = [*rows()[:-1], faulty("size-2", options=2)]
    card = scorecard(some, ROSTER, seed=0)
    assert card.macro.headline == Headline(None, pytest.approx(5 / 12), pytest.approx(2 / 3), 5, 1)
    refused = (card.macro, card.question_types[1])
    for it in refused:
        assert it.corrected is it.beyond_guessing is it.student is it.bootstrap is it.wilson is None
    assert card.question_types[0].headline.value == pytest.approx(1 / 3)  # Find lacks nothing
    assert card.detectable is None
    assert card.gaps == (Gap("size-2", "size", 0, "RenderFailed: gone"),)
    assert card.macro.runs == 4
    assert card.outcomes[1].missing == 1


def test_a_part_is_refused_where_one_of_its_tasks_is_missing():
    card = scorecard(rows()[1:], ROSTER, seed=0)
    values = {part.name: part.headline.value for part in card.parts}
    assert values == {"find, letter alone": None, "find, hidden": None, "find, partly": 0}


def test_all_failed():
    card = scorecard([faulty("find-1", stratum="hidden")], ROSTER, seed=0)
    assert (card.macro.headline.worst, card.macro.headline.best) == (0, 1)
    assert (card.icc, card.detectable, card.effort.episodes) == (None, None, 0)


def test_all_right():
    card = scorecard([row("find-1"), row("find-2")], roster("find-1", "find-2"), seed=0)
    low = proportion_confint(2, 2, method="wilson")[0]
    assert (card.macro.headline.value, card.macro.student.low) == (1, pytest.approx(low))
    assert card.macro.student.high == card.macro.bootstrap.high == 1
    assert card.detectable is None


def test_two_entrants_have_no_card():
    with pytest.raises(ContraryRows):
        scorecard([row("find-1"), row("find-2", agent="bob")], roster("find-1", "find-2"), seed=0)


def test_a_suite_without_find_has_no_letter():
    card = scorecard([row("size-1", options=2)], roster("size-1", options=2), seed=0)
    assert card.parts == ()


def test_a_type_lacks_a_run_that_only_other_types_have():
    rows = [row("find-0"), row("size-0"), row("size-0", run=1)]
    card = scorecard(rows, roster("find-0", "size-0"), seed=0)
    find, size = card.question_types
    assert (find.headline.value, find.headline.missing, find.headline.rows) == (None, 1, 2)
    assert (find.headline.worst, find.headline.best) == (0.5, 1.0)
    assert size.headline.value == 1.0


def test_a_card_has_the_version_of_its_tools_and_no_two():
    rows = [row("find-1", tools=2), row("find-2", tools=2)]
    assert scorecard(rows, roster("find-1", "find-2"), 0).tools == 2
    with pytest.raises(ContraryRows, match="has version 1 of the tools, others have 2"):
        scorecard([rows[0], row("find-2", tools=1)], roster("find-1", "find-2"), 0)


def test_right_answers_that_took_more_than_one_needless_manipulation_are_not_restrained():
    """By hand: two types, two tasks each; 0 to 2 manipulations are necessary."""
    needs = {"find-1": 0, "find-2": 1, "count-1": 2, "count-2": 0}
    used = {"find-1": 1, "find-2": 3, "count-1": 1, "count-2": 5}
    rows = [
        row(task, task != "count-2", necessary=least, manipulations=used[task])
        for task, least in needs.items()
    ]
    listed = {task: Listed(task.split("-")[0], "", 5, least) for task, least in needs.items()}
    card = scorecard(rows, listed, 0)
    assert card.macro.headline.value == 0.75
    # Find: 1 of 2, as the second took 2 too many. Count: 1 of 2, as the second is wrong.
    assert card.restrained.headline.value == 0.5
    assert [(it.name, it.tasks, it.headline.value) for it in card.by_necessary] == [
        ("0", 2, 0.5),
        ("1", 1, 1.0),
        ("2", 1, 1.0),
    ]
    assert (card.needless.n, card.needless.total) == (4, 1 + 2 + 0 + 5)
    # A look answers those that need none, so that nothing is beyond it.
    at_sight, one, _ = card.by_necessary
    assert (at_sight.naive, at_sight.corrected) == (1, None)
    assert (one.naive, one.corrected) == (0.2, 1)


def test_letters_alone_have_the_floors_of_a_guessed_letter():
    told = {"answer": "B", "letter_correct": True, "necessary": 1}
    rows = [row("exact-1", False, **told), row("exact-2", False, necessary=1)]
    listed = {task: Listed("exact", "", 5, 1) for task in ("exact-1", "exact-2")}
    card = scorecard(rows, listed, 0)
    (letter,) = (it for it in card.parts if it.name == "exact, letter alone")
    assert (card.macro.chance, card.macro.naive) == (0, 0)
    assert (letter.headline.value, letter.chance, letter.naive) == (0.5, 0.2, 0.2)


def test_accuracy_by_necessary_manipulations_is_of_tasks_and_not_of_types():
    """Three of four Find tasks and the one of Size are right: 4 of 5, not the mean of 3/4 and 1."""
    tasks = [*(f"find-{n}" for n in range(4)), "size-1"]
    options = {"find": 5, "size": 2}
    listed = {it: Listed(it.split("-")[0], "", options[it.split("-")[0]], 1) for it in tasks}
    rows = [
        row(task, task != "find-0", necessary=1, options=one.options)
        for task, one in listed.items()
    ]
    (figure,) = scorecard(rows, listed, 0).by_necessary
    assert figure.headline.value == pytest.approx(4 / 5)
    assert figure.chance == pytest.approx((4 * 0.2 + 0.5) / 5)
    # Wilson's interval of 4 of 5, by the formula with z = 1.96.
    assert (figure.wilson.low, figure.wilson.high) == pytest.approx((0.3755, 0.9638), abs=1e-4)


def test_one_task_that_does_not_state_what_is_necessary_leaves_restraint_unknown():
    rows = [row("find-1", necessary=0), row("find-2")]
    listed = {"find-1": Listed("find", "", 5, 0), "find-2": Listed("find", "", 5)}
    card = scorecard(rows, listed, 0)
    assert (card.restrained, card.by_necessary, card.needless) == (None, (), None)
