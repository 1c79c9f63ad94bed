import numpy as np
import pytest

from probe.scores.estimates import corrected, macro, macro_chance
from probe.scores.roster import Listed, chance_by_type, letter_guessed, naive_by_type, roster_of
from score_rows import roster, row


def test_types_weigh_alike_however_many_tasks_they_have():
    assert macro({"find": np.array([1.0]), "size": np.array([0.0, 0.0, 0.5])}) == pytest.approx(
        7 / 12
    )
    assert macro({"find": np.array([1 / 3])}) == pytest.approx(1 / 3)


def test_chance_of_the_paper_suite_is_thirty_percent():
    six = {
        **roster("find-1", "count-1", "reduce-1", "beneath-1", "beneath-2"),
        **roster("compare-1", "size-1", options=2),
    }
    chance = chance_by_type(six)
    assert chance == {
        "beneath": 0.2,
        "compare": 0.5,
        "count": 0.2,
        "find": 0.2,
        "reduce": 0.2,
        "size": 0.5,
    }
    assert macro_chance(chance) == pytest.approx(0.30)


def test_counting_what_shows_is_the_naive_ceiling_of_count():
    six = {
        **roster("find-1", "count-1", "reduce-1", "beneath-1"),
        **roster("compare-1", "size-1", options=2),
    }
    naive = naive_by_type(six)
    assert naive == chance_by_type(six) | {"count": pytest.approx(1 / 3)}
    # 0.2, 0.5, 1/3, 0.2, 0.2, 0.5 over six types.
    assert macro_chance(naive) == pytest.approx(1.6 / 6 + 1 / 18)
    # With two numbers to choose from a guess is better than that.
    assert naive_by_type(roster("count-1", options=2)) == {"count": 0.5}


def test_a_look_is_enough_where_no_manipulation_is_necessary():
    tasks = {
        "find-1": Listed("find", "hidden", 5, necessary=0),
        "find-2": Listed("find", "hidden", 5, necessary=2),
        "count-1": Listed("count", "", 5, necessary=0),
        "count-2": Listed("count", "", 5, necessary=1),
    }
    assert chance_by_type(tasks) == {"count": 0.2, "find": 0.2}
    # Half of each type at sight: (1 + 0.2) / 2, and (1 + 1/3) / 2.
    assert naive_by_type(tasks) == {"count": pytest.approx(2 / 3), "find": 0.6}


def test_nobody_removes_things_by_a_guess():
    both = roster("exact-1", "reduce-1")
    assert chance_by_type(both) == naive_by_type(both) == {"exact": 0.0, "reduce": 0.2}
    letters = {"exact": 0.2, "reduce": 0.2}
    assert chance_by_type(both, letter_guessed) == letters
    assert naive_by_type(both, letter_guessed) == letters


def test_chance_is_a_mean_over_tasks():
    mixed = {**roster("size-1", "size-2", options=2), **roster("size-3", options=5)}
    assert chance_by_type(mixed)["size"] == pytest.approx((0.5 + 0.5 + 0.2) / 3)


@pytest.mark.parametrize(
    ("value", "chance", "beyond"),
    [(0.3, 0.3, 0), (1, 0.3, 1), (0.65, 0.3, 0.5), (0.1, 0.2, -0.125)],
)
def test_accuracy_beyond_chance(value, chance, beyond):
    assert corrected(value, chance) == pytest.approx(beyond)


def test_a_roster_from_rows_lists_each_task_once():
    rows = [
        row("find-1", stratum="partly"),
        row("find-1", run=1, stratum="partly"),
        row("size-1", options=2),
    ]
    assert roster_of(rows) == {
        "find-1": Listed("find", "partly", 5),
        "size-1": Listed("size", "", 2),
    }
