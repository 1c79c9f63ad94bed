from __future__ import annotations

import pytest

from lessons import lesson, training_task
from probe.train.efficiency import failures, limits, waste

TASK = training_task(1)


def moves(*pairs):
    return lesson(TASK, statuses=pairs).record


@pytest.mark.parametrize(
    ("counts", "slack", "limit"), [((1, 2, 5), 1, 3), ((1, 2, 3, 9), 0, 2), ((4,), 2, 6)]
)
def test_the_limit_is_the_median_and_something(counts, slack, limit):
    records = [("find", moves(*[("mug", "done")] * count)) for count in counts]
    assert limits(records, slack) == {"find": limit}


def test_one_failure_at_a_thing_is_let_pass_and_two_are_not():
    once = moves(("mug", "failed"), ("box", "failed"), ("mug", "done"))
    twice = moves(("mug", "failed"), ("box", "done"), ("mug", "failed"))
    assert dict(failures(twice)) == {"mug": 2}
    assert waste(once, 3) is None
    assert waste(twice, 3) == "failed twice at one thing"


def test_too_many_and_useless_calls():
    assert waste(moves(("mug", "done"), ("box", "done")), 1) == "too many manipulations"
    assert waste(moves(("mug", "done"), ("box", "refused")), 1) == "a call that did nothing"
