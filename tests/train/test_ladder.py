from __future__ import annotations

from dataclasses import replace

import pytest

from lessons import lesson, training_task
from probe.episodes.participation import ModelReply, Participation
from probe.episodes.record import EpisodeRecord, Step
from probe.episodes.turns import Call
from probe.scores.row import Entrant
from probe.toolshed.refusals import BudgetSpent, StaleHandle, UnknownHandle
from probe.toolshed.result import Status
from probe.train.ladder import Share, ladder, markdown, rungs_of

BASE = lesson(training_task(1, "count")).record


def step(name: str, values: dict[str, object] | str, text: str, status: Status = "done") -> Step:
    call = Call(name, values) if isinstance(values, str) else Call.of(name, values)
    return Step(call, status, text, None, BASE.start)


def listing(**points: tuple[int, int]) -> Step:
    """A list in which the things with these ids are at these points."""
    lines = ["objects:"]
    for number, (id, (u, v)) in enumerate(points.items(), start=1):
        lines += [f"- number: {number}", f"  object_id: {id}", "  name: mug"]
        lines += ["  description: A mug.", f"  point: [{u}, {v}]"]
        lines += [f"  box: [{u - 9}, {v - 9}, {u + 9}, {v + 9}]"]
    return step("perceive_scene", {}, "\n".join(["count: 1", *lines, "relations: []"]))


def finding(u: float, v: float, status: Status = "done") -> Step:
    return step("find_object", {"description": f"the thing at ({u}, {v})"}, "object_id: x", status)


def grasping(id: str, text: str = "Done: so it is.", status: Status = "done") -> Step:
    return step("grasp_and_remove", {"object_id": id}, text, status)


def record(*steps: Step, wordless: int = 0) -> EpisodeRecord:
    replies = [*(ModelReply(1) for _ in steps), *(ModelReply(0, "Hm.") for _ in range(wordless))]
    seat = Participation("text-only", "0-1000", tuple(replies))
    return replace(BASE, steps=steps, participation=seat, answer=None, end="stopped")


def test_calls_in_the_wrong_form_and_replies_without_one():
    played = record(
        listing(object_1=(100, 100)),
        step("push", "{not JSON", "push did nothing: ...", "malformed"),
        step("fly", {}, "There is no tool called 'fly'.", "malformed"),
        grasping("object_1", "Nothing was moved: all 2 manipulations are used up.", "refused"),
        wordless=2,
    )
    # The list and the refused grasp, of four calls and two replies without one.
    assert rungs_of(played, right=False).formed == Share(2, 6)


def test_what_fits_its_tool_is_in_the_right_form_though_this_question_takes_it_not():
    played = record(
        step("answer_question", {"choice": "B"}, "Point at it, too.", "malformed"),
        step("answer_question", {"choice": "E"}, "There is no option E.", "malformed"),
        step("answer_question", {"choice": "Z"}, "answer_question did nothing: ...", "malformed"),
    )
    assert rungs_of(played, right=False).formed == Share(2, 3)


def test_places_that_a_list_has_told():
    played = record(
        finding(100, 100),  # before any list
        listing(object_1=(100, 100), object_2=(300, 500)),
        finding(100.3, 99.6),
        finding(300, 110),
        step("find_object", {"description": "red mug"}, "object_id: x"),  # no numbers
        listing(object_2=(310, 500), object_3=(700, 700)),
        finding(300, 500),  # told first, and that id still holds
        finding(310, 500),
        finding(100, 100),  # object_1 is gone
    )
    assert rungs_of(played, right=False).listed == Share(3, 6)


def test_object_ids_that_hold():
    stale, unknown = str(StaleHandle("object_1")), str(UnknownHandle("object_9", ["object_1"]))
    played = record(
        listing(object_1=(100, 100)),
        grasping("object_1", "The hand was stopped.", "failed"),
        grasping("object_1", stale, "malformed"),
        grasping("object_9", unknown, "malformed"),
        step("push", {"object_id": "object_1"}, "push did nothing: direction", "malformed"),
        step("push", {"object_id": "object_1", "direction": "left"}, "Done: it moved."),
        grasping("object_7", str(BudgetSpent(10)), "refused"),
    )
    found = rungs_of(played, right=False)
    assert found.holding == Share(2, 4)
    # An object_id that doesn't hold is in the right form.
    assert found.formed == Share(6, 7)


def test_everything_in_a_table_by_entrant():
    one, two = Entrant("base", "text-only"), Entrant("student", "text-only")
    silent = record(wordless=2)
    good = replace(record(listing(object_1=(5, 5)), grasping("object_1")), answer=BASE.answer)
    found = ladder([(one, silent, False), (two, good, True), (two, silent, False)])
    assert list(found) == [one, two]
    assert found[two].formed == Share(2, 4)
    assert found[two].answered == found[two].right == Share(1, 2)
    lines = markdown([(who.agent, it) for who, it in found.items()]).splitlines()
    assert len({line.count("|") for line in lines}) == 1
    assert lines[2].split(" | ")[1:3] == ["0.0 % (0 of 2)", "none"]
    assert lines[3].split(" | ")[3:] == ["100.0 % (1 of 1)", "50.0 % (1 of 2)", "50.0 % (1 of 2) |"]


@pytest.mark.parametrize("values", ["[]", "3", '{"description": 7}'])
def test_odd_arguments_are_no_place(values):
    played = record(step("find_object", values, "The episode has ended.", "refused"))
    assert rungs_of(played, right=False).listed == Share()
