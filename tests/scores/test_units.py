# An unexpected None fails a test as well as a check of its type does.
# pyright: reportOptionalMemberAccess=false, reportOptionalOperand=false, reportArgumentType=false

import numpy as np
import pytest

from probe.scores.units import (
    ContraryRows,
    MissingRows,
    Unit,
    by_entrant,
    strata_of,
    units_of,
)
from score_rows import faulty, row, unit


def test_a_task_is_one_unit_however_often_it_was_run():
    rows = [
        row("find-1", True, run=0),
        row("count-1", False, run=0),
        row("find-1", False, run=1),
        row("find-1", True, run=2),
    ]
    assert units_of(rows) == [
        Unit("find-1", "find", (1.0, 0.0, 1.0)),
        Unit("count-1", "count", (0.0,)),
    ]
    assert units_of(rows)[0].mean == pytest.approx(2 / 3)


def test_another_worth_may_be_asked_for():
    missed = row("find-1", False, answer="B", letter_correct=True, outcome="missed")
    assert units_of([missed])[0].mean == 0
    assert units_of([missed], lambda it: it.letter_correct)[0].mean == 1


def test_a_failure_of_ours_is_never_passed_over():
    with pytest.raises(MissingRows) as error:
        units_of([row("find-1"), faulty("find-2", run=4)])
    assert str(error.value) == (
        "Run 4 of anna at find-2 failed on our side (RenderFailed: gone); it is neither right nor "
        "wrong. Run it again, or ask for the worst and the best case."
    )


@pytest.mark.parametrize(
    ("second", "reason"),
    [
        (row("find-1"), "it is there twice"),
        (row("find-2", agent="bob"), r"others are by anna \(agentic\)"),
        (row("find-2", setting="direct"), r"others are by anna \(agentic\)"),
        (row("find-1", run=1, question_type="count"), "the task has two types"),
    ],
)
def test_rows_that_cannot_stand_together_are_refused(second, reason):
    remedy = r"\. Take the rows of one suite, each run once\.$"
    with pytest.raises(ContraryRows, match=f": {reason}{remedy}"):
        units_of([row("find-1"), second])


def test_no_rows_no_units():
    assert units_of([]) == []
    assert strata_of([]) == {}


def test_means_by_type_in_order_of_name():
    strata = strata_of([unit("size-1", 1, 0), unit("find-1", 1), unit("size-2", 0)])
    assert list(strata) == ["find", "size"]
    assert np.array_equal(strata["size"], [0.5, 0.0])


def test_entrants_in_order():
    rows = [
        row("find-1", agent="bob"),
        row("find-1"),
        row("find-2", setting="direct"),
        row("find-2"),
    ]
    found = by_entrant(rows)
    assert list(found) == [("anna", "agentic"), ("anna", "direct"), ("bob", "agentic")]
    assert found["anna", "agentic"] == [rows[1], rows[3]]
