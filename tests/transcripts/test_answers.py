"""Answers at the end of replies."""

import pytest

from probe.toolshed.result import Answer
from probe.transcripts.answers import read_answer


@pytest.mark.parametrize(
    ("reply", "answer"),
    [
        ("ANSWER: B", Answer("B")),
        ("It is red.\nANSWER: C (512, 300)", Answer("C", (512.0, 300.0))),
        ("**ANSWER: b**", Answer("B")),
        ("**Answer:** D", Answer("D")),
        ("> ANSWER: A.", Answer("A")),
        ("ANSWER: (E)", Answer("E")),
        ("ANSWER: A [3.5, 4]", Answer("A", (3.5, 4.0))),
        ("ANSWER: B, (512, 300)", Answer("B", (512.0, 300.0))),
        ("ANSWER: B at (512, 300)", Answer("B", (512.0, 300.0))),
        ("ANSWER: A at (512, 300)", Answer("A", (512.0, 300.0))),
        ("ANSWER: B: (512, 300)", Answer("B", (512.0, 300.0))),
        ("ANSWER: B (u=512, v=300)", Answer("B", (512.0, 300.0))),
        ("ANSWER: **B** [x: 512, y: 300]", Answer("B", (512.0, 300.0))),
        ("ANSWER: B\nPoint: (512, 300)", Answer("B", (512.0, 300.0))),
        ("ANSWER: B, the mug (red), (5, 3) rather than (6, 4)", Answer("B", (5.0, 3.0))),
        ("At (1, 2).\nANSWER: B", Answer("B")),
        ("ANSWER: B (1, 2, 3, 4)", Answer("B")),
        ("ANSWER: A, a red mug", Answer("A")),
        ("ANSWER: **A** red mug", Answer("A")),
        ("ANSWER: E None of the above", Answer("E")),
        ("Answer: a red mug", None),
        ("ANSWER: A or B", None),
        ("ANSWER: C/D", None),
        ("ANSWER: A\nNo, wait.\nANSWER: B", Answer("B")),
        ("The answer is B.", None),
        ("ANSWER: Banana", None),
        ("ANSWER: X", None),
        ("ANSWER:", None),
        ("ANSWER:\nA dog", None),
        ("", None),
        ("I might say ANSWER: B later", None),
    ],
)
def test_the_last_line_of_that_form_counts(reply, answer):
    assert read_answer(reply, "pixels") == answer


def test_letters_that_are_no_option_are_no_answer():
    assert read_answer("ANSWER: C", "pixels", "AB") is None


def test_a_point_is_in_pixels_in_the_end():
    assert read_answer("ANSWER: A (500, 250)", "0-1000") == Answer("A", (512.0, 256.0))
