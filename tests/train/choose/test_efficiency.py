from __future__ import annotations

from dataclasses import replace

import pytest

from lessons import lesson, reminded, training_task
from probe.episodes.turns import Call
from probe.train.choose.efficiency import failures, limits, waste

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
    useless = moves(("mug", "done"), ("box", "refused"))
    assert waste(useless, 1) == "a call or reply that did nothing"


@pytest.mark.parametrize("setting", ["agentic", "direct"])
def test_a_reply_that_needed_a_reminder_did_nothing(setting):
    it = lesson(TASK, setting=setting)
    assert waste(it.record, 1) is None
    assert waste(reminded(it).record, 1) == "a call or reply that did nothing"


def test_a_thing_is_the_same_under_the_object_id_that_a_reply_gave_it():
    """Nobody looked in between."""
    played = moves(("mug", "failed"))
    find, grasp, _ = played.steps
    grasp = replace(grasp, text="Failed: the gripper met it. It is object_77 now.")
    again = failing(grasp, "object_77")
    assert dict(failures(replace(played, steps=(find, grasp, again)))) == {"mug": 2}
    unnamed = failing(grasp, "object_8"), failing(grasp, "object_9")
    assert waste(replace(played, steps=unnamed), 3) is None


def failing(step, handle):
    return replace(step, call=Call.of("grasp_and_remove", {"object_id": handle}), text="Failed.")


def test_an_agent_without_a_seat_is_reminded_of_nothing():
    assert waste(replace(lesson(TASK).record, participation=None), 1) is None
