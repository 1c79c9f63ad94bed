import pydantic
import pytest

from score_rows import faulty, row


@pytest.mark.parametrize(
    ("changes", "reason"),
    [
        ({"correct": True, "letter_correct": False, "answer": "C"}, "with a wrong letter"),
        ({"answer": "C"}, "letter_correct isn't what the letters say"),
        ({"answer": None}, "letter_correct isn't what the letters say"),
        ({"fault": "gone"}, "a fault has words"),
        ({"end": "fault"}, "a fault has words"),
        ({"manipulations": 0}, "manipulated isn't"),
        ({"manipulated": False}, "manipulated isn't"),
        ({"options": 1}, "greater than or equal to 2"),
        ({"run": -1}, "greater than or equal to 0"),
        ({"cost": float("nan")}, "finite"),
        ({"colour": "red"}, "Extra inputs"),
        ({"end": "fault", "fault": ""}, "at least 1 character"),
    ],
)
def test_rows_that_contradict_themselves_are_refused(changes, reason):
    with pytest.raises(pydantic.ValidationError, match=reason):
        row("find-1", True, **changes)


def test_a_right_letter_without_its_point_is_no_contradiction():
    assert row("find-1", False, answer="B", letter_correct=True, outcome="missed").letter_correct


def test_a_row_knows_whose_it_is_and_whether_it_is_missing():
    assert row("find-1").entrant == ("anna", "agentic")
    assert not row("find-1", False).missing
    assert faulty("find-1").missing
