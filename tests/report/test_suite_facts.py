from dataclasses import replace

import pytest

from probe.report.suite_facts import suite_facts
from probe.scene.visibility import Visibility
from probe.tasks.task import Certificate, Option
from task_examples import FIND, with_answer


def test_letters_visibilities_and_measures_are_counted():
    seen = Certificate({2: Visibility(90, 900)}, {"visible_share": 0.1}, ())
    other = replace(with_answer("E"), certificate=seen)
    (facts,) = suite_facts([FIND, other])
    assert (facts.question_type, facts.tasks) == ("find", 2)
    assert facts.letters == (0, 1, 0, 0, 1)
    assert facts.target_seen is not None
    # 10 of 900 pixels and 90 of 900.
    assert facts.target_seen.median == pytest.approx((1 / 90 + 1 / 10) / 2)
    ((name, spread),) = facts.measures
    assert (name, spread.n) == ("visible_share", 2)
    assert spread.mean == pytest.approx((1 / 90 + 1 / 10) / 2)


def test_letters_that_are_not_offered_and_targets_that_are_not_there_are_unknown():
    pair = replace(
        FIND, question_type="size", options=(Option("A", "x"), Option("B", "y")), targets=()
    )
    find, size = suite_facts([pair, FIND])
    assert (find.question_type, size.question_type) == ("find", "size")
    assert size.letters == (0, 1, None, None, None)
    assert size.target_seen is None
