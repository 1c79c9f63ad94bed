"""Names, progress, states: values without a table."""

from dataclasses import replace

import pytest

from interfaces.human.painted_hall import COUNT
from probe.episodes.grading import question_of
from probe.episodes.turns import Call
from probe.errors import OutputFailed, RenderFailed
from probe.interfaces.human.call_entries import CallEntry, handles_of
from probe.interfaces.human.names import BadName, file_of, name_of
from probe.interfaces.human.practice import practice_for
from probe.interfaces.human.progress import HumanProgress
from probe.interfaces.human.state import State, as_json, at_table
from probe.interfaces.human.words import trouble_words
from probe.interfaces.words import instructions
from probe.tasks.suite_file import demo_suite, packaged_suite
from run_folders import episode
from task_examples import FIND

FOUND = "object_id: object_1\nname: lime"


def test_names_are_tidied():
    assert name_of("  Ada \t Lovelace ") == "Ada Lovelace"
    assert name_of("Zoe\u0308") == "Zo\u00eb"
    assert name_of("x" * 40) == "x" * 40


@pytest.mark.parametrize("said", ["", "   ", "x" * 41, "a\0b", "a\u202eb", "a\u2028b", "\x1b[31m"])
def test_names_that_would_not_print_are_refused(said):
    with pytest.raises(BadName, match="1 to 40 characters"):
        name_of(said)


def test_a_persons_file_is_safe_on_any_disk():
    assert file_of("../../etc/passwd") != file_of("CON")
    assert file_of("Ada").removesuffix(".jsonl").isalnum()


def test_questions_come_in_the_suites_order_and_once():
    progress = HumanProgress((FIND, COUNT), [])
    assert progress.next() == (0, FIND) and progress.done == 0
    assert progress.next(after=FIND) == (1, COUNT)
    progress.add(episode(FIND))
    assert progress.next() == (1, COUNT) and progress.done == 1
    assert progress.next(after=COUNT) is None
    progress.add(episode(COUNT))
    assert progress.next() is None and progress.done == progress.total == 2


def test_a_failure_of_ours_is_made_good_twice_in_the_same_run():
    progress = HumanProgress((FIND, COUNT), [episode(FIND, fault="a dead renderer")] * 2)
    assert progress.next() == (0, FIND) and progress.run_of(FIND) == 0
    progress.add(episode(FIND, fault="again"))
    assert progress.next() == (1, COUNT)


def test_handles_come_with_what_the_tools_called_the_things_the_latest_last():
    looked = "objects:\n- number: 1\n  object_id: object_2\n  description: something small"
    near = "Nothing that shows is called 'egg'. Nearest: object_3, red box, at [5, 5]. Look again."
    told = (("find_object", FOUND), ("perceive_scene", looked), ("find_object", near))
    again = (("find_object", FOUND), ("push", "object_id: object_9"), ("find_object", "Nothing."))
    entries = tuple(CallEntry(Call(tool, "{}"), "done", text, 1, True) for tool, text in told)
    assert handles_of(entries) == [
        {"id": "object_2", "called": "something small"},
        {"id": "object_3", "called": "red box"},
    ], "object_1 isn't in the newest list"
    entries += tuple(CallEntry(Call(tool, "{}"), "done", text, 1, True) for tool, text in again)
    assert [each["id"] for each in handles_of(entries)] == ["object_2", "object_3", "object_1"]


def test_of_all_that_fits_what_was_searched_for_is_the_latest():
    others = "others_that_fit_as_well:\n- object_id: object_2\n  name: lime"
    found = CallEntry(Call("find_object", "{}"), "done", f"{FOUND}\n{others}", 1, True)
    assert [each["id"] for each in handles_of((found,))] == ["object_2", "object_1"]


@pytest.mark.parametrize(
    ("tool", "text", "left"),
    [
        ("grasp_and_remove", "Done: object_1 was lifted and dropped into the basket.", []),
        ("push", "Done: object_1 ended up in the basket.", []),
        ("push", "Failed: the gripper went the whole way. object_1 lies in the basket.", []),
        (
            "push",
            "Failed: it went. object_1 lies beside the basket, at the edge of the picture.",
            [],
        ),
        (
            "grasp_and_remove",
            "Failed: it slipped. object_1 is still about where it was.",
            ["object_1"],
        ),
        ("push", "Done: object_1 moved about 5 cm that way; it is object_2 now.", ["object_2"]),
        ("push", "Failed: object_1 is still on the table. It is object_4 now.", ["object_4"]),
        ("push", "Done: object_1 moved. Also in the basket now: lime.", ["object_1"]),
    ],
)
def test_what_was_moved_away_is_offered_no_more_and_a_new_id_takes_the_place_of_the_old(
    tool, text, left
):
    found = CallEntry(Call("find_object", "{}"), "done", FOUND, 1, True)
    moved = CallEntry(Call.of(tool, {"object_id": "object_1"}), "done", text, 2, True)
    shown = handles_of((found, moved))
    assert [each["id"] for each in shown] == left
    assert {each["called"] for each in shown} <= {"lime"}


def test_practice_leaves_out_what_is_measured():
    demo, v1 = demo_suite(), packaged_suite("v1")
    practice = practice_for(v1)
    assert practice and practice.tasks == demo.tasks and practice.name == "practice"
    assert practice_for(demo) is None


def test_the_page_is_told_what_is_left():
    entry = CallEntry(Call.of("push", {"distance_cm": 5}), "refused", "No.", 0, False)
    said = as_json(replace(State(), entries=(entry,) * 3, manipulations=10))
    assert (said["turnsLeft"], said["manipulationsLeft"]) == (37, 0)
    assert said["entries"][0]["arguments"] == {"distance_cm": "5"}


def test_the_page_is_told_of_a_smaller_budget():
    state = at_table(State(), 0, replace(FIND, manipulations=3), None)
    assert as_json(state)["manipulationsLeft"] == 3


def test_clients_are_told_of_a_smaller_budget():
    usual, few = (question_of(replace(FIND, manipulations=it)) for it in (None, 3))
    assert "10 of them may be grasps or pushes" in instructions(usual)
    assert "3 of them may be grasps or pushes" in instructions(few)


def test_troubles_of_ours_are_not_told_in_detail():
    assert "secret_mug" not in trouble_words(RenderFailed("secret_mug"))
    assert "disk is full" in trouble_words(OutputFailed("secret/path", "No space left"))
    assert "secret" not in trouble_words(OutputFailed("secret/path", "No space left"))
