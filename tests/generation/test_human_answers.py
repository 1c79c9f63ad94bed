"""What is expected was counted by hand, or stands in the literature."""

import pytest

from probe.generation.human_answers import HumanAnswer, agreements, alpha_of, efforts, verdicts


def said(
    task,
    person,
    letter,
    *,
    correct=False,
    question_type="find",
    turns=4,
    seconds: float | None = 10,
):
    return HumanAnswer(task, question_type, person, letter, correct, turns, 1, seconds)


def test_tasks_that_people_fail_or_doubt_are_dropped():
    people = [
        said("good", "ada", "A", correct=True),
        said("good", "bea", "A", correct=True),
        said("half", "ada", "A", correct=True),
        said("half", "bea", "B"),
        said("bad", "ada", "A"),
        said("doubted", "ada", "C", correct=True),
    ]
    notes = {"doubted": {"ada": "two limes"}}
    found = verdicts(["good", "half", "bad", "doubted", "new"], people, notes, least=0.5)
    assert [(v.task, v.people, v.right, v.reason) for v in found] == [
        ("good", 2, 2, "kept"),
        ("half", 2, 1, "kept"),
        ("bad", 1, 0, "failed"),
        ("doubted", 1, 1, "ambiguous"),
        ("new", 0, 0, "not tried"),
    ]
    assert [v.task for v in found if v.dropped] == ["bad", "doubted"]
    strict = verdicts(["half"], people, {}, least=0.6)
    assert strict[0].dropped
    (lenient,) = verdicts(["doubted"], people, notes, least=0.5, doubters=2)
    assert not lenient.dropped and lenient.notes == {"ada": "two limes"}


def test_somebody_who_gave_up_counts_as_not_right_and_has_no_letter():
    people = [said("t", "ada", None), said("t", "bea", "A", correct=True)]
    (verdict,) = verdicts(["t"], people, {}, least=0.6)
    assert (verdict.people, verdict.right, verdict.reason) == (2, 1, "failed")
    assert agreements(people)[-1].pairs == 0


def test_krippendorffs_own_example():
    # Three observers, 15 units, some missing; alpha for nominal data is 0.691.
    # (Krippendorff, Computing Krippendorff's Alpha-Reliability, 2011; also Wikipedia.)
    rows = ["*****34121133*3", "1*213343*******", "**21344*21133*4"]
    units = [[row[i] for row in rows if row[i] != "*"] for i in range(15)]
    assert alpha_of(units) == pytest.approx(0.691, abs=0.0005)


def test_alpha_at_its_limits():
    assert alpha_of([["A", "A"], ["B", "B"]]) == 1
    assert alpha_of([["A", "A"], ["A", "A"]]) is None
    assert alpha_of([["A"], []]) is None
    # Two units, each split: n = 4, observed 2 + 2, expected 8, so 1 - 3 * 4 / 8.
    assert alpha_of([["A", "B"], ["B", "A"]]) == pytest.approx(-0.5)


def test_agreement_is_counted_by_type_and_over_all():
    people = [
        *(said("t1", who, letter) for who, letter in [("ada", "A"), ("bea", "A"), ("cy", "B")]),
        *(said("t2", who, "E", question_type="count") for who in ("ada", "bea")),
        said("t3", "ada", "C"),
    ]
    count, find, both = agreements(people)
    assert (count.name, count.tasks, count.pairs, count.same) == ("count", 1, 1, 1)
    assert (find.name, find.tasks, find.pairs, find.same) == ("find", 1, 3, 1)
    assert (both.name, both.tasks, both.pairs, both.same) == ("all", 2, 4, 2)
    assert count.alpha is None and find.alpha is not None


def test_effort_is_told_by_percentiles():
    people = [said("t", str(n), "A", correct=n > 5, turns=n, seconds=10.0 * n) for n in range(11)]
    (_, both) = efforts(people)
    assert (both.episodes, both.right) == (11, 5)
    assert both.turns == (1.0, 5.0, 9.0) and both.seconds == (10.0, 50.0, 90.0)
    (unknown, _) = efforts([said("t", "ada", "A", seconds=None)])
    assert unknown.seconds is None
