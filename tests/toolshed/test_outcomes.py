"""What is said after a manipulation when the hand and the cameras disagree."""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import pytest
import yaml

from probe.agents.reading import grasp_outcome
from probe.perception.oracle import Oracle
from probe.scene.setup import UR5_TABLE
from probe.toolshed.outcomes import at_least
from probe.toolshed.skills import Direction
from probe.toolshed.toolshed import Toolshed
from tabletops import Block, Done, PaintedStation, spec

SPECS = {
    41: spec("red mug", "red"),
    42: spec("blue book", "blue"),
    43: spec("white ball", "white"),
    44: spec("green die", "green"),
    45: spec("white ball", "white"),
}
MUG = Block(41, (100, 100, 219, 219))
BOOK = Block(42, (500, 300, 799, 699), height=0.02, colour=(30, 60, 150))
BALL = Block(43, (600, 450, 679, 529), height=0.08, colour=(240, 240, 240))


class Skills:
    """A hand that claims one thing while the table does another."""

    def __init__(self, status, after, removed=(), moved=None, shove=None):
        self.status, self.after, self.removed, self.moved = status, list(after), removed, moved
        self.shove = shove

    def _go(self, station):
        station.blocks = self.after
        station.removed += self.removed
        return Done(self.status, station.observe(rgb=False), self.moved, self.shove)

    def grasp_and_remove(self, station, frame, mask, setup):
        return self._go(station)

    def push(self, station, frame, mask, direction, distance, setup):
        return self._go(station)


def told(name, skills, tool="grasp_and_remove", blocks=(MUG, BOOK, BALL), **arguments):
    shed = Toolshed(PaintedStation(blocks), Oracle(SPECS), skills, UR5_TABLE)
    found = yaml.safe_load(shed.call("find_object", {"description": name}).text)
    return shed.call(tool, {"object_id": found["object_id"], **arguments})


def moved(block, du):
    left, top, right, bottom = block.box
    return Block(block.instance, (left + du, top, right + du, bottom), block.height, block.colour)


def test_another_thing_in_the_basket_is_no_success():
    result = told("blue book", Skills("removed", [MUG, BOOK], [BALL]))
    assert result.status == "failed"
    assert "object_1 is still about where it was." in result.text
    assert "Also in the basket now: white ball." in result.text


def test_what_nobody_saw_before_and_went_along_is_said():
    hidden = Block(44, (600, 450, 679, 529), height=0.04, colour=(40, 120, 40))
    result = told("blue book", Skills("removed", [MUG, BALL], [BOOK, hidden]))
    assert "Also in the basket now: green die, not seen before." in result.text


def test_what_went_along_is_said():
    result = told("blue book", Skills("removed", [MUG], [BOOK, BALL]))
    assert result.text == (
        "Done: object_1 was lifted and dropped into the basket. Also in the basket now: white "
        "ball. Manipulations left: 9."
    )


def test_a_thing_in_plain_view_is_not_out_of_reach():
    result = told("red mug", Skills("moved", [moved(MUG, 200), BOOK, BALL]))
    assert "object_1 is still on the table, now at [359, 159]." in result.text


def test_a_thing_that_is_gone_is_not_said_to_be_in_the_basket():
    result = told("red mug", Skills("removed", [BOOK, BALL]))
    assert result.status == "failed"
    assert "object_1 shows neither on the table nor in the basket." in result.text


def test_of_a_sliver_that_is_gone_it_is_not_said_that_nothing_shows_it():
    sliver = Block(43, (310, 400, 349, 419), height=0.03, colour=(240, 240, 240), share=0.1)
    shed = Toolshed(
        PaintedStation([MUG, BOOK, sliver]), Oracle(SPECS), Skills("moved", [MUG, BOOK]), UR5_TABLE
    )
    found = yaml.safe_load(shed.call("find_object", {"description": "at (330, 410)"}).text)
    gone = shed.call("grasp_and_remove", {"object_id": found["object_id"]}).text
    assert "object_1, of which only a part showed, was not found again." in gone
    shed = Toolshed(
        PaintedStation([MUG, BOOK, sliver]), Oracle(SPECS), Skills("removed", [BOOK], [MUG]),
        UR5_TABLE,
    )  # fmt: skip
    found = yaml.safe_load(shed.call("find_object", {"description": "red mug"}).text)
    also = shed.call("grasp_and_remove", {"object_id": found["object_id"]}).text
    assert "Not found again: part of something that is mostly hidden (white" in also
    assert ") that was at [319, 409]" in also


def test_what_the_hand_lost_into_the_basket_is_done():
    result = told("red mug", Skills("dropped", [BOOK, BALL], [MUG]))
    assert result.text.startswith("Done: object_1 ended up in the basket.")


def test_what_shows_otherwise_in_the_basket_must_be_what_was_held():
    other_side = Block(41, MUG.box, MUG.height, (20, 20, 20), share=0.1)
    result = told("red mug", Skills("removed", [BOOK, BALL], [other_side]))
    assert result.status == "done"


def test_bystanders_are_named_with_their_places():
    result = told("red mug", Skills("removed", [BOOK, moved(BALL, -300)], [MUG]))
    assert "Also moved: white ball by about 16 cm, to [339, 489]." in result.text


@pytest.mark.parametrize(("by", "same"), [(0, True), (15, True), (60, False)])
def test_an_id_holds_until_a_reply_says_that_its_thing_has_moved(by: int, same: bool):
    shed = Toolshed(
        PaintedStation([MUG, BOOK]),
        Oracle(SPECS),
        Skills("removed", [moved(BOOK, by)], [MUG]),
        UR5_TABLE,
    )

    def id_of(name: str) -> str:
        return yaml.safe_load(shed.call("find_object", {"description": name}).text)["object_id"]

    book = id_of("blue book")
    reply = shed.call("grasp_and_remove", {"object_id": id_of("red mug")}).text
    assert ("blue book" in reply) is not same
    assert (id_of("blue book") == book) is same


def test_what_has_moved_is_told_with_its_new_id():
    shed = Toolshed(
        PaintedStation([MUG, BOOK, BALL]),
        Oracle(SPECS),
        Skills("removed", [moved(BOOK, 90), moved(BALL, 90)], [MUG]),
        UR5_TABLE,
    )

    def id_of(name: str) -> str:
        return yaml.safe_load(shed.call("find_object", {"description": name}).text)["object_id"]

    mug, book = id_of("red mug"), id_of("blue book")
    reply = shed.call("grasp_and_remove", {"object_id": mug}).text
    assert (book, id_of("blue book")) == ("object_2", "object_3")
    place = "[{}, {}]".format(
        *yaml.safe_load(shed.call("find_object", {"description": "blue book"}).text)["point"]
    )
    assert f"blue book by about 5 cm, to {place} (object_3 now)" in reply
    # Nobody had an id for the ball.
    assert "white ball by about 5 cm, to" in reply and reply.count(" now)") == 1


def test_of_two_like_things_that_moved_it_is_not_said_which_went_where():
    twin = Block(45, (850, 450, 929, 529), height=0.08, colour=(240, 240, 240))
    went = [moved(BALL, -300), moved(twin, -100)]
    result = told(
        "red mug", Skills("removed", [BOOK, *went], [MUG]), blocks=[MUG, BOOK, BALL, twin]
    )
    assert (
        "Also moved, and which is which can't be told: white ball from [639, 489] and [889, 489] "
        "to [339, 489] and [789, 489]."
    ) in result.text
    assert "Also moved: " not in result.text


SLIVER = Block(43, (310, 400, 349, 419), height=0.03, colour=(240, 240, 240), share=0.1)


def beside_a_part(part: Block, *after: Block) -> str:
    shed = Toolshed(
        PaintedStation([MUG, BOOK, part]),
        Oracle(SPECS),
        Skills("removed", [BOOK, *after], [MUG]),
        UR5_TABLE,
    )
    found = yaml.safe_load(shed.call("find_object", {"description": "red mug"}).text)
    return shed.call("grasp_and_remove", {"object_id": found["object_id"]}).text


def test_how_far_something_went_of_which_a_part_showed_is_not_told():
    told_of = beside_a_part(SLIVER, replace(SLIVER, box=(410, 400, 449, 419)))
    assert (
        "May have moved, as only a part showed before: part of something that is mostly hidden "
        "(white, what shows is flat boxy) from [319, 409] to [419, 409]."
    ) in told_of
    assert "Also moved" not in told_of


def test_what_came_to_light_is_named_where_it_may_be_what_was_not_found():
    # A lid of another colour: half of it is as the part was.
    part, lid = replace(SLIVER, instance=44), Block(44, (600, 450, 679, 529), 0.08, (40, 120, 40))
    half = replace(part, box=(640, 450, 679, 529), height=0.09, share=1.0)
    also = beside_a_part(part, lid, half)
    assert "that was at [319, 409], unless it is green die at [639, 489]." in also


def test_a_part_that_is_not_found_may_belong_to_anything_that_came_to_light():
    green, gray = ((44, (40, 120, 40)), (45, (90, 90, 90)))
    new = [
        Block(number, (500 + 200 * k, 650, 579 + 200 * k, 729), 0.04, colour)
        for k, (number, colour) in enumerate((green, gray))
    ]
    also = beside_a_part(SLIVER, *new)
    assert (
        "(white, what shows is flat boxy) that was at [319, 409], unless it belongs to something "
        "that has come to light."
    ) in also
    nothing_new = beside_a_part(SLIVER)
    assert "that was at [319, 409]. Manipulations" in nothing_new


def test_how_high_something_lies_that_has_tipped_is_not_told():
    lower = replace(moved(BALL, -300), height=0.03)
    assert "down in height" in told("red mug", Skills("removed", [BOOK, lower], [MUG])).text
    tipped = replace(lower, box=(300, 430, 339, 589))
    text = told("red mug", Skills("removed", [BOOK, tipped], [MUG])).text
    assert "turned or tipped" in text and "in height" not in text


@pytest.mark.parametrize(("said", "moved_by"), [("moved that way, to", 0.12), ("is now at", 0.03)])
def test_how_far_a_pushed_thing_went_is_not_told_by_a_part_of_it(said, moved_by):
    over = Block(43, (390, 60, 600, 240), height=0.08, colour=(240, 240, 240))
    result = told(
        "red mug", Skills("pushed", [moved(MUG, 220), BOOK, over], moved=moved_by),
        blocks=[MUG, BOOK], tool="push", direction="right", distance_cm=12,
    )  # fmt: skip
    assert f"{said} [354, 134] (how far can't be told, since it shows" in result.text
    assert result.status == ("done" if moved_by > 0.06 else "failed")


def test_a_pushed_thing_that_reaches_the_pictures_edge_may_have_gone_further():
    result = told(
        "red mug", Skills("pushed", [moved(MUG, 804), BOOK], moved=0.12),
        blocks=[MUG, BOOK], tool="push", direction="right", distance_cm=12,
    )  # fmt: skip
    assert "moved at least 11 cm that way, to [963, 159]" in result.text


@pytest.mark.parametrize(("way", "said"), [(0.3, 0), (1.6, 1), (2.3, 1), (2.8, 2), (7.6, 6)])
def test_a_least_distance_leaves_room_for_outlines_that_mislead(way, said):
    assert at_least(way) == said


BAR = Block(42, (500, 300, 539, 699), height=0.02, colour=(30, 60, 150))
ACROSS = Block(42, (500, 700, 899, 739), height=0.02, colour=(30, 60, 150))


def test_a_thing_that_moved_and_turned_is_told_as_both():
    def bar_told(name, skills, **arguments):
        return told(name, skills, blocks=[MUG, BAR], **arguments).text

    beside = bar_told("red mug", Skills("removed", [ACROSS], [MUG]))
    assert "Also moved: blue book by about 16 cm, to [519, 719], turned or tipped." in beside
    lost = bar_told("blue book", Skills("dropped", [MUG, ACROSS]))
    assert "still on the table, now at [519, 719], turned or tipped. It is object_2 now." in lost
    pushed = bar_told(
        "blue book", Skills("pushed", [MUG, ACROSS], moved=0.12), tool="push",
        direction="right", distance_cm=12,
    )  # fmt: skip
    assert "moved about 12 cm that way, to [519, 719], turned or tipped; it is object_2" in pushed
    slid = bar_told("red mug", Skills("removed", [moved(BAR, 100)], [MUG]))
    assert "to [619, 319]. Manipulations" in slid


def test_a_push_that_hardly_moved_the_thing_has_failed():
    arguments = {"direction": "left", "distance_cm": 10}
    short = told("red mug", Skills("pushed", [moved(MUG, -53), BOOK, BALL], moved=0.03), "push",
                 **arguments)  # fmt: skip
    assert short.status == "failed" and "moved about 3 cm that way, to [106, 159]" in short.text
    far = told("red mug", Skills("pushed", [moved(MUG, -90), BOOK, BALL], moved=0.051), "push",
               **arguments)  # fmt: skip
    assert far.status == "done"


def test_a_thing_that_moved_is_told_with_its_new_handle():
    result = told("red mug", Skills("moved", [moved(MUG, 200), BOOK, BALL]))
    assert "now at [359, 159]. It is object_2 now." in result.text


class Shove(NamedTuple):
    direction: Direction
    moved: float | None


PUSHED_FIRST = (
    "the fingers found no way to object_1, so the closed gripper first pushed it about 4 cm "
    "towards the right of the picture"
)


def test_a_push_before_a_grasp_is_told_even_if_all_went_well():
    skills = Skills("removed", [BOOK, moved(BALL, -300)], [MUG], shove=Shove("right", 0.041))
    result = told("red mug", skills)
    assert result.text == (
        "Done: object_1 was lifted and dropped into the basket. T" + PUSHED_FIRST[1:] + ". Also "
        "moved: white ball by about 16 cm, to [339, 489]. Manipulations left: 9."
    )


@pytest.mark.parametrize("status", ["no_candidate", "unreachable"])
def test_a_push_after_which_there_is_still_no_grip_is_told_with_the_new_place(status):
    result = told(
        "red mug", Skills(status, [moved(MUG, 200), BOOK, BALL], shove=Shove("right", 0.04))
    )
    assert result.status == "failed" and "Nothing was moved" not in result.text
    assert result.text == (
        f"Failed: {PUSHED_FIRST}. After that there was no grip on it either. object_1 is still on "
        "the table, now at [359, 159]. It is object_2 now. Push it further, or first clear what "
        "stands around it. Manipulations left: 9."
    )
    assert grasp_outcome(result.text) == "no grip"


def test_a_push_before_a_grasp_that_failed_is_told_first():
    text = told("red mug", Skills("blocked", [MUG, BOOK, BALL], shove=Shove("right", 0.04))).text
    assert text.startswith(
        f"Failed: {PUSHED_FIRST}. Then the gripper touched something and stopped. object_1 is "
    )
    assert grasp_outcome(text) == "blocked"


def test_of_what_a_push_took_out_of_sight_no_distance_and_no_grasp_is_told():
    text = told("red mug", Skills("moved", [BOOK, BALL], shove=Shove("up", None))).text
    assert text == (
        "Failed: the fingers found no way to object_1, so the closed gripper first pushed it "
        "towards the top of the picture. object_1 shows neither on the table nor in the basket. "
        "Manipulations left: 9."
    )


class Twice(Skills):
    """A hand whose second grasp leaves the table and the basket otherwise than the first."""

    def __init__(self, *times):
        super().__init__("removed", ())
        self.times = list(times)

    def _go(self, station):
        self.after, self.removed = self.times.pop(0)
        return super()._go(station)


def test_what_is_known_to_lie_in_the_basket_is_not_told_again():
    skills = Twice(([BOOK, BALL], [MUG]), ([BALL], []))
    station = PaintedStation([MUG, BOOK, BALL])
    shed = Toolshed(station, Oracle(SPECS), skills, UR5_TABLE)
    for name in ("red mug", "blue book"):
        found = yaml.safe_load(shed.call("find_object", {"description": name}).text)
        result = shed.call("grasp_and_remove", {"object_id": found["object_id"]})
    assert "not seen before" not in result.text
