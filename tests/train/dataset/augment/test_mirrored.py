"""A mirrored episode is what the real tools say at a mirrored table."""

from __future__ import annotations

from dataclasses import replace

import pytest

from packed_teacher import packed_episodes
from probe.episodes.grading import question_of
from probe.episodes.participation import ModelReply, Participation
from probe.episodes.record import EpisodeRecord, Step, TableState
from probe.episodes.turns import Call
from probe.perception.oracle import Oracle
from probe.scene.setup import UR5_TABLE
from probe.tasks.suite_file import demo_suite, packaged_suite
from probe.toolshed.result import Answer
from probe.toolshed.toolshed import Toolshed
from probe.train.collect.teacher import speaker
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.listed_ids import SayWithoutFinding
from probe.train.dataset.augment.mirrored import mirrored
from probe.train.dataset.augment.rephrasing import rephrased
from probe.train.dataset.examples import example_of
from probe.train.dataset.text_only import no_pictures
from tabletops import Block, Done, Obedient, PaintedStation, spec

SPECS = {
    1: spec("red mug", "red"),
    2: spec("blue book", "blue"),
    3: spec("white ball", "white"),
    4: spec("green teapot", "green"),
    5: spec("green teapot", "green"),
}
# Higher than wide, with an odd number of columns, so that one column is the deepest inside.
BLOCKS = [
    Block(1, (100, 100, 218, 299)),
    Block(2, (560, 320, 660, 699), height=0.02, colour=(30, 60, 150)),
    Block(3, (661, 450, 729, 549), height=0.08, colour=(240, 240, 240)),
    Block(4, (300, 400, 330, 470), height=0.03, colour=(40, 120, 50)),
    Block(5, (420, 400, 450, 470), height=0.06, colour=(40, 120, 50)),
]
FIND = next(task for task in demo_suite().tasks if task.question_type == "find")
TABLE = TableState(FIND.scene, (0.0,) * 6)


class Following(Obedient):
    """Pushes the way that it is told."""

    def push(self, station, frame, mask, direction, distance_m, basket) -> Done:
        station.shift(mask, {"left": -60, "right": 60}[direction], 0)
        return Done("pushed", station.observe(rgb=False))


def flipped(blocks):
    """The same blocks in a mirrored picture of 1024 columns."""
    boxes = [(1023 - b.box[2], b.box[1], 1023 - b.box[0], b.box[3]) for b in blocks]
    return [replace(block, box=box) for block, box in zip(blocks, boxes, strict=True)]


def played(blocks, calls) -> EpisodeRecord:
    """An episode of the real tools at painted blocks."""
    shed = Toolshed(PaintedStation(blocks), Oracle(SPECS), Following(), UR5_TABLE, pictures=False)
    steps = list[Step]()
    for call in calls:
        result = shed.call(call.name, call.values)
        steps.append(Step(call, result.status, result.text, result.point_px, TABLE))
    return EpisodeRecord(
        FIND.id, "scripted", 0, question_of(FIND), TABLE, tuple(steps), Answer("A"), "answered"
    )


def find(u, v, words=""):
    return Call.of("find_object", {"description": f"the thing at ({u}, {v})"}, words)


def push(id, way, words):
    return Call.of("push", {"object_id": id, "direction": way, "distance_cm": 6.0}, words)


LOOK = Call.of("perceive_scene", words="Let me see what can be made out in the picture.")


def grasp(id):
    return Call.of("grasp_and_remove", {"object_id": id}, "Found. I remove the white ball.")


def test_it_is_what_the_tools_say_at_the_mirrored_table():
    """The teapots are equally high, so that they change places and object_ids in the list."""
    calls = [
        LOOK, find(159, 159),
        push("object_1", "right", "That is the right place. I slide the red mug right."),
        LOOK, find(315, 415), find(695, 484), grasp("object_5"), LOOK,
        Call.of("answer_question", {"choice": "A", "point": [315, 415]}),
    ]  # fmt: skip
    there = [
        LOOK, find(864, 159),
        push("object_1", "left", "That is the right place. I slide the red mug left."),
        LOOK, find(708, 415), find(328, 484), grasp("object_5"), LOOK,
        Call.of("answer_question", {"choice": "A", "point": [708, 415]}),
    ]  # fmt: skip
    here, expected = played(BLOCKS, calls), played(flipped(BLOCKS), there)
    assert [step.status for step in here.steps] == ["done"] * len(calls)
    assert "object_1 moved" in here.steps[2].text and "left_of" in here.steps[0].text
    found = mirrored(FIND, here)
    for one, other in zip(found.steps, expected.steps, strict=True):
        assert (one.call, one.text) == (other.call, other.text)
    # The other teapot comes first at the mirrored table, and gets object_3 there.
    assert here.steps[4].text.startswith('object_id: object_3\nname: "green teapot"')
    assert found.steps[4].text.startswith('object_id: object_4\nname: "green teapot"')


def counted(*each):
    said = "All that seemed able to hide one has been searched. I count "
    words = f"{said}{' and '.join(each)}. That is {len(each)}, so A."
    return Call.of("answer_question", {"choice": "A"}, words)


def test_object_ids_in_words_are_those_of_the_mirrored_table():
    """The teapots change places in the list, and with it their object_ids."""
    one = played(BLOCKS, [LOOK, counted("object_3")])
    assert "I count object_4." in mirrored(FIND, one).steps[-1].call.words
    # Which of them it would name first, nobody can tell.
    level = played(BLOCKS, [LOOK, counted("object_3", "object_4")])
    with pytest.raises(NotCertain, match="names equally high things in an order"):
        mirrored(FIND, level)
    other = played(BLOCKS, [LOOK, counted("object_1", "object_3")])
    assert "object_1 and object_4" in mirrored(FIND, other).steps[-1].call.words
    # They were, in an earlier list.
    moved = played(BLOCKS, [LOOK, find(315, 415), grasp("object_3"), LOOK])
    later = replace(moved.steps[-1], call=counted("object_3", "object_4"))
    with pytest.raises(NotCertain, match="names equally high things in an order"):
        mirrored(FIND, replace(moved, steps=(*moved.steps[:-1], moved.steps[-1], later)))


def test_mirrored_twice_it_is_the_same_again():
    here = played(BLOCKS, [LOOK, find(159, 159), grasp("object_1"), LOOK])
    assert mirrored(FIND, here) != here
    assert mirrored(FIND, mirrored(FIND, here)) == here


def test_marks_in_the_question_are_mirrored():
    task = next(it for it in packaged_suite("v1").tasks if it.question_type == "compare")
    record = replace(played(BLOCKS, [LOOK]), task=task.id, question=question_of(task))
    (a, b) = task.marks
    assert f"A at ({a.point[0]}, {a.point[1]})" in task.question
    text = mirrored(task, record).question.text
    assert f"A at ({1023 - a.point[0]}, {a.point[1]})" in text
    assert f"B at ({1023 - b.point[0]}, {b.point[1]})." in text
    assert text.split(" In the")[0] == task.question.split(" In the")[0]


def test_marks_that_the_teacher_names_are_mirrored():
    """In pixels, and in thousandths, in which it says what its student reads."""
    task = next(it for it in packaged_suite("v1").tasks if it.question_type == "compare")
    look = played(BLOCKS, [LOOK])
    u, v = task.marks[1].point
    named = replace(LOOK, words=f"Mark B at ({u}, {v}) is on object_2.")
    asked = replace(look, task=task.id, question=question_of(task))
    record = replace(asked, steps=(replace(look.steps[0], call=named),))
    said = mirrored(task, record).steps[0].call.words
    assert said.startswith(f"Mark B at ({1023 - u}, {v}) is on object_")
    whole = f"({round(u / 1.024)}, {round(v / 1.024)})"
    counted = replace(LOOK, words=f"Mark B at {whole} is on object_2.")
    seat = seated(replace(record, steps=(replace(look.steps[0], call=counted),)))
    said = mirrored(task, seat).steps[0].call.words
    assert f"({round((1023 - u) / 1.024)}, {round(v / 1.024)})" in said
    elsewhere = replace(LOOK, words="Mark B at (5, 6) is on object_2.")
    with pytest.raises(NotCertain, match="a place that isn't a mark's"):
        mirrored(task, replace(record, steps=(replace(look.steps[0], call=elsewhere),)))


def test_whole_thousandths_stay_whole():
    """A teacher that counts in thousandths names the place that its student reads in the list."""
    # 159 and 864 pixels are 155 and 844 thousandths.
    call = Call.of("find_object", {"description": "the thing at (158.72, 158.72)"})
    here = played(BLOCKS, [LOOK, call])
    seat = seated(here)
    example = example_of(FIND, mirrored(FIND, seat), no_pictures(seat))
    assert "844, 155" in example.messages[3].text
    assert example.messages[4].calls[0][1].values == {"description": "the thing at (844, 155)"}


def seated(record: EpisodeRecord) -> EpisodeRecord:
    """The record of an agent that counts in thousandths, without pictures."""
    replies = tuple(ModelReply(1) for _ in record.steps)
    return replace(record, participation=Participation("text-only", "0-1000", replies))


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        ({"call": replace(LOOK, words="On the left I see a mug.")}, "spoke freely"),
        ({"call": Call("perceive_scene", "{ }")}, "written in another way"),
        ({"status": "malformed"}, "was refused"),
        ({"text": "# Nothing shows."}, "another form"),
    ],
)
def test_what_cant_be_mirrored_for_sure_is_refused(change, reason):
    here = played(BLOCKS, [LOOK])
    with pytest.raises(NotCertain, match=reason):
        mirrored(FIND, replace(here, steps=(replace(here.steps[0], **change),)))


def test_a_question_that_goes_round_the_table_is_refused():
    """Mirrored, another thing would be the next one."""
    ring = next(it for it in packaged_suite("v2").tasks if it.question_type == "relation")
    here = played(BLOCKS, [LOOK])
    with pytest.raises(NotCertain, match="its question speaks of a side"):
        mirrored(ring, replace(here, task=ring.id, question=question_of(ring)))


def test_a_place_that_the_list_doesnt_tell_is_refused():
    with pytest.raises(NotCertain, match="a place that the last list doesn't tell"):
        mirrored(FIND, played(BLOCKS, [LOOK, find(160, 160)]))


def test_several_things_in_an_unknown_order_are_refused():
    """The teapots are equally high; which of them is told first can't be read from the reply."""
    here = played(BLOCKS, [LOOK, find(159, 159), grasp("object_1")])
    both = "Done: object_1 was lifted. Also moved: mug by about 2 cm, to [5, 6]; "
    several = replace(here.steps[2], text=f"{both}ball by about 1 cm, to [7, 8]. ")
    with pytest.raises(NotCertain, match="several moved in an order that no list tells"):
        mirrored(FIND, replace(here, steps=(*here.steps[:2], several)))


def test_late_object_ids_of_equally_high_things_are_refused():
    """What is new in a list after a grasp may have got its object_id before the list."""
    here = played(BLOCKS, [LOOK, find(159, 159), grasp("object_1"), LOOK])
    late = here.steps[3].text.replace("object_3", "object_8").replace("object_4", "object_9")
    steps = (*here.steps[:3], replace(here.steps[3], text=late))
    with pytest.raises(NotCertain, match="equally high things got their object_ids late"):
        mirrored(FIND, replace(here, steps=steps))


def test_to_what_it_is_told_at_the_mirrored_table_the_teacher_says_the_mirrored_words(tmp_path):
    """Of the packed episodes, those without pushes, for which it chooses among ways by chance."""
    compared = 0
    for task, record in packed_episodes(tmp_path):
        say = SayWithoutFinding(speaker(task, record.run))
        spoken = rephrased(task, record, say)
        try:
            told = mirrored(task, spoken)
        except NotCertain:
            continue
        if "push" in [step.call.name for step in record.steps]:
            continue
        again = rephrased(task, told, SayWithoutFinding(speaker(task, record.run)))
        assert [it.call.words for it in again.steps] == [it.call.words for it in told.steps]
        compared += 1
    assert compared > 10
