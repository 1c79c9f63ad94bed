import pytest

from probe.scores.missing import Gap, Headline, filled, gaps_of, headline, present, runs_of, settled
from probe.scores.units import ContraryRows
from score_rows import faulty, roster, row, unit

ROSTER = roster("find-1", "find-2", "size-1")


def test_a_whole_run_has_a_headline():
    rows = [row("find-1"), row("find-2", False), row("size-1", False)]
    assert headline(rows, ROSTER) == Headline(0.25, 0.25, 0.25, rows=3, missing=0)


def test_a_failure_of_ours_refuses_it_and_gives_bounds():
    rows = [row("find-1"), faulty("find-2"), row("size-1", False)]
    # Find 1/2 or 2/2, Size 0.
    assert headline(rows, ROSTER) == Headline(None, 0.25, 0.5, rows=3, missing=1)


def test_pooled_it_is_over_tasks():
    rows = [row("find-1"), faulty("find-2"), row("size-1", False)]
    # 1 or 2 of three tasks; over types it would be 1/4 or 1/2.
    top = headline(rows, ROSTER, pool=True)
    assert top.value is None and top.missing == 1
    assert (top.worst, top.best) == (pytest.approx(1 / 3), pytest.approx(2 / 3))


def test_what_was_never_run_is_missing_too():
    rows = [row("find-1"), row("find-2")]
    assert headline(rows, ROSTER) == Headline(None, 0.5, 1.0, rows=3, missing=1)
    assert gaps_of(rows, ROSTER) == [Gap("size-1", "size", 0, "never run")]


def test_each_task_should_have_each_run():
    rows = [
        row("find-1", True, run=0),
        row("find-1", False, run=1),
        row("find-2", True, run=1),
        faulty("size-1", run=0),
        row("size-1", True, run=1),
    ]
    assert gaps_of(rows, ROSTER) == [
        Gap("find-2", "find", 0, "never run"),
        Gap("size-1", "size", 0, "RenderFailed: gone"),
    ]
    # Find: (1/2 + 1/2) / 2 or (1/2 + 2/2) / 2; Size: 1/2 or 2/2.
    assert headline(rows, ROSTER) == Headline(None, 0.5, 0.875, rows=6, missing=2)


def test_each_task_should_have_each_run_that_was_ordered():
    rows = [row("find-1", ordered=2), row("find-2", ordered=2), row("size-1", ordered=2)]
    assert gaps_of(rows, ROSTER) == [
        Gap(task, question_type, 1, "never run")
        for task, question_type in (("find-1", "find"), ("find-2", "find"), ("size-1", "size"))
    ]
    assert headline(rows, ROSTER) == Headline(None, 0.5, 1.0, rows=6, missing=3)


def test_without_an_order_runs_are_those_that_exist():
    assert runs_of([row("find-1", run=1), row("find-2", run=3)]) == {1, 3}
    assert runs_of([row("find-1", run=1, ordered=3)]) == {0, 1, 2}


def test_a_run_that_only_failed_is_expected_of_all():
    rows = [row("find-1"), row("find-2"), row("size-1"), faulty("find-1", run=1)]
    assert [gap.task for gap in gaps_of(rows, ROSTER)] == ["find-1", "find-2", "size-1"]


def test_nobody_who_ran_nothing():
    assert headline([], ROSTER) == Headline(None, 0.0, 1.0, rows=3, missing=3)
    assert gaps_of([], roster("find-1")) == [Gap("find-1", "find", 0, "never run")]


def test_another_worth_is_bounded_alike():
    missed = row("find-1", False, answer="B", letter_correct=True, outcome="missed")
    rows = [missed, faulty("find-2")]
    some = roster("find-1", "find-2")
    assert headline(rows, some).worst == 0
    assert headline(rows, some, lambda it: it.letter_correct).worst == 0.5


@pytest.mark.parametrize(
    "stranger",
    [
        row("find-9"),
        row("find-1", options=2),
        row("find-1", stratum="partly"),
        row("find-1", question_type="size"),
    ],
)
def test_tasks_of_another_suite_are_refused(stranger):
    with pytest.raises(ContraryRows, match=": the task isn't of this suite\\. Take"):
        gaps_of([row("find-2"), stranger], ROSTER)


def test_a_repetition_takes_the_place_of_a_failure():
    first, again = faulty("find-1"), row("find-1", False)
    assert settled([first, again]) == [again]
    assert settled([again, first]) == [again]
    assert settled([first, faulty("find-1", fault="again")]) == [faulty("find-1", fault="again")]
    others = [
        row("find-1", run=1),
        row("find-2"),
        row("find-1", setting="direct"),
        row("find-1", agent="b"),
    ]
    assert settled([again, *others]) == [again, *others]


def test_two_results_of_a_run_are_refused():
    words = r"Run 0 of anna \(agentic\) at find-1: it has two results\. Take the rows of one suite"
    with pytest.raises(ContraryRows, match=words):
        settled([row("find-1"), faulty("find-1"), row("find-1", False)])


def test_filling_leaves_what_is_there():
    rows = [row("find-1"), faulty("find-1", run=1), row("size-1", False)]
    assert present(rows) == [rows[0], rows[2]]
    gaps = [Gap("find-1", "find", 1, ""), Gap("find-2", "find", 0, "")]
    assert filled(rows, gaps, 0.0) == [unit("find-1", 1, 0), unit("size-1", 0), unit("find-2", 0)]
