"""What tools reply in few words holds what is needed to act."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import pytest

from probe.perception.oracle import Oracle
from probe.scene.setup import UR5_TABLE
from probe.toolshed.toolshed import TURNS, Toolshed
from probe.transcripts.result_texts import ResultTexts
from probe.transcripts.short_graphs import ListEntry, known_after, short_list
from probe.transcripts.short_results import ShortResults
from tabletops import Block, Obedient, PaintedStation, spec

SPECS = {1: spec("red mug"), 2: spec("red mug"), 3: spec("blue book", "blue"), 4: spec("red coin")}
BLOCKS = (
    Block(1, (100, 100, 219, 219)),
    Block(2, (350, 550, 399, 599), height=0.15),
    Block(3, (300, 500, 499, 699), colour=(40, 85, 170)),
    Block(4, (360, 560, 389, 589), height=0.1),
)
# The book's point: as far from the corner of the mug on it as from its own edges.
FIRST = (
    "# All that shows, from top to bottom: object_id, [u, v] on it, what it is, object_id, its "
    "[width, height], colours if its name has none, what lies on or covers it, what it touches if "
    'it has no name. In later lists "new" stands before names that this one lacks, "another" '
    "before new object_ids of names that it has."
)
LATER = "# Changed since the last list:"


def table() -> Toolshed:
    return Toolshed(PaintedStation(BLOCKS), Oracle(SPECS), Obedient(), UR5_TABLE, pictures=False)


def told(tools: Toolshed, texts: ShortResults, name: str, **arguments: object) -> str:
    return texts.shortened(name, tools.call(name, arguments).text)


def test_the_first_list_tells_all_and_later_ones_what_changed():
    tools, texts = table(), ShortResults()
    assert told(tools, texts, "perceive_scene").split("\n") == [
        FIRST,
        "- object_1 at [159, 159]: red mug, object_1, [120, 120]",
        "- object_2 at [374, 574]: red mug, object_2, [50, 50]",
        "- object_3 at [441, 641]: blue book, object_3, [200, 200], under object_2",
    ]
    assert told(tools, texts, "perceive_scene") == "# Nothing has changed since the last list."
    done = told(tools, texts, "grasp_and_remove", object_id="object_2")
    assert done.startswith("Done: object_2 was lifted and dropped into the basket.")
    assert told(tools, texts, "perceive_scene").split("\n") == [
        LATER,
        "- object_4 at [374, 574], new: red coin, object_4, [30, 30]",
        "- object_3 at [435, 635]: blue book, object_3, [200, 200], under object_4",
        "out of date: object_2",
    ]


def entry(u: int, v: int = 50, width: int = 20, under: tuple[str, ...] = ()) -> ListEntry:
    return ListEntry("red mug", (u, v), size=(width, 20), under=under)


def test_what_is_told_for_the_first_time_is_marked_by_whether_the_first_list_has_its_name():
    texts = ShortResults()
    texts.shortened("perceive_scene", whole_list([("red mug", 40), ("blue book", 80)]))
    second = whole_list([("red coin", 40), ("blue book", 80), ("blue book", 200)])
    assert texts.shortened("perceive_scene", second).split("\n")[1:] == [
        "- object_1 at [40, 50], new: red coin, object_1, [11, 11]",
        "- object_3 at [200, 50], another: blue book, object_3, [11, 11]",
    ]
    # What is only told again isn't marked.
    third = whole_list([("red coin", 60), ("blue book", 90), ("red coin", 300)])
    assert texts.shortened("perceive_scene", third).split("\n")[1:] == [
        "- object_1 at [60, 50]: red coin, object_1, [11, 11]",
        "- object_2 at [90, 50]: blue book, object_2, [11, 11]",
        "- object_3 at [300, 50], new: red coin, object_3, [11, 11]",
    ]


def whole_list(things: Sequence[tuple[str, int]], description: str = "It.") -> str:
    """A list of things by name and where they are."""
    entries = "".join(
        f'- number: {n}\n  object_id: object_{n}\n  name: "{name}"\n'
        f'  description: "{description}"\n'
        f"  point: [{u}, 50]\n  box: [{u - 5}, 45, {u + 5}, 55]\n"
        for n, (name, u) in enumerate(things, start=1)
    )
    return f"# x\nobjects:\n{entries}relations: []\ncluttered: []\nclear: []"


@pytest.mark.parametrize(
    ("name", "description", "colours"),
    [
        ("viking helmet", "A gray and gold Viking helmet with two horns.", ", gray and gold"),
        ("young leek", "A light green leek with a white shaft.", ", light green"),
        ("espresso cup", "A small white espresso cup.", ", white"),
        ("tray", "A rectangular gray metal baking tin.", ", gray"),
        ("red and blue mug", "A green mug.", ""),
        ("wooden crate", "A wooden crate.", ""),
        ("greenhouse", "A greenhouse of white bars.", ", white"),
    ],
)
def test_colours_are_told_where_the_name_has_none(name, description, colours):
    told = ShortResults().shortened("perceive_scene", whole_list([(name, 50)], description))
    assert told.split("\n")[1] == f"- object_1 at [50, 50]: {name}, object_1, [11, 11]{colours}"


def test_what_is_listed_after_an_empty_table_is_a_first_list():
    texts = ShortResults()
    empty = "# x\nobjects: []\nrelations: []\ncluttered: []\nclear: []"
    assert texts.shortened("perceive_scene", empty) == "# Nothing shows."
    told = texts.shortened("perceive_scene", whole_list([("red mug", 40)]))
    assert told == f"{FIRST}\n- object_1 at [40, 50]: red mug, object_1, [11, 11]"


def test_colours_that_a_description_has_now_are_told():
    texts = ShortResults()
    texts.shortened("perceive_scene", whole_list([("crate", 50)], "A wooden crate."))
    told = texts.shortened("perceive_scene", whole_list([("crate", 50)], "A brown crate."))
    assert told == f"{LATER}\n- object_1 at [50, 50]: crate, object_1, [11, 11], brown"


def test_a_place_that_differs_is_told_again_and_two_pixels_are_not_much():
    texts = ["# Nothing has changed since the last list."] * 2
    texts.append(f"{LATER}\n- object_1 at [103, 50]: red mug, object_1, [20, 20]")
    known = known_after(None, {"object_1": entry(100)})
    for u, text in zip((102, 98, 103), texts, strict=True):
        assert short_list(known, {"object_1": entry(u)}) == text
    for changed, told in (
        (entry(100, v=53), "[100, 53]: red mug, object_1, [20, 20]"),
        (entry(100, width=23), "[100, 50]: red mug, object_1, [23, 20]"),
        (replace(entry(100), what="mug"), "[100, 50]: mug, object_1, [20, 20]"),
        (entry(100, under=("object_2",)), "[100, 50]: red mug, object_1, [20, 20], under object_2"),
    ):
        assert short_list(known, {"object_1": changed}) == f"{LATER}\n- object_1 at {told}"


def test_that_what_lay_on_it_is_out_of_date_is_not_told_twice():
    before = {"object_1": entry(100, under=("object_2", "object_3")), "object_2": entry(300)}
    before["object_3"] = entry(500)
    now = {"object_1": entry(100, under=("object_3",)), "object_3": entry(500)}
    known = known_after(None, before)
    assert short_list(known, now) == f"{LATER}\nout of date: object_2"
    later = known_after(known, now)
    assert short_list(later, now) == "# Nothing has changed since the last list."
    lifted = {"object_1": entry(100), "object_3": entry(500)}
    assert short_list(later, lifted).split("\n")[1:] == [
        "- object_1 at [100, 50]: red mug, object_1, [20, 20]"
    ]


def test_only_what_has_no_name_says_what_it_touches():
    hidden = replace(BLOCKS[2], share=0.05)
    beside = Block(1, (500, 500, 619, 699))
    blocks, specs = (hidden, beside), Oracle(SPECS)
    tools = Toolshed(PaintedStation(blocks), specs, Obedient(), UR5_TABLE, pictures=False)
    listed = told(tools, ShortResults(), "perceive_scene").split("\n")[1:]
    part = next(line for line in listed if "part of something" in line)
    assert part.endswith(", touching object_1") or part.endswith(", touching object_2")
    assert not [line for line in listed if line != part and "touching" in line]


@pytest.mark.parametrize("what", ["u", "width"])
def test_what_creeps_is_told_before_it_is_far_from_what_was_told(what):
    known, told = None, list[int]()
    for number in range(100, 120):
        now = {"object_1": entry(number) if what == "u" else entry(100, width=number)}
        known = known_after(known, now)
        it = known["object_1"]
        assert it.size is not None
        told.append(it.point[0] if what == "u" else it.size[0])
        assert abs(told[-1] - number) <= 2
    assert sorted({*told}) == [100, 103, 106, 109, 112, 115, 118]


def test_a_thing_that_is_found_is_a_line_with_its_box_and_description():
    tools, texts = table(), ShortResults()
    found = told(tools, texts, "find_object", description="the thing at (400, 680)")
    assert (
        found
        == "- object_1 at [441, 641]: blue book, object_1, box [300, 500, 499, 699]: A blue book."
    )
    mugs = told(tools, texts, "find_object", description="red mug").split("\n")
    assert mugs == [
        "- object_2 at [159, 159]: red mug, object_2, box [100, 100, 219, 219]: A red mug.",
        "others_that_fit_as_well:",
        "- object_3 at [374, 574]: red mug, object_3",
    ]


def test_what_else_has_moved_is_mentioned_and_stands_in_the_next_list():
    texts = ShortResults()
    whole = (
        "Done: object_1 was lifted and dropped into the basket. Also moved: red mug by about 5 cm, "
        "to [20, 30]; part of something (red, what shows is flat) turned or tipped, now at "
        "[9, 9]. Out of sight, and something else is over that place: blue book that was at "
        "[4, 5]. Manipulations left: 9."
    )
    assert texts.shortened("grasp_and_remove", whole) == (
        "Done: object_1 was lifted and dropped into the basket. Others moved, too. Out of sight, "
        "and something else is over that place: blue book that was at [4, 5]. Manipulations "
        "left: 9."
    )
    plain = "Failed: the gripper did not get hold of object_1. Manipulations left: 8."
    assert texts.shortened("push", plain) == plain


@pytest.mark.parametrize(
    "next_sentence",
    [
        "Also moved, and which is which can't be told: egg from [1, 2] and [3, 4] to [5, 6] and "
        "[7, 8].",
        "May have moved, as only a part showed before: whisk from [1, 2] to [3, 4].",
        "Beside the basket, at the edge of the picture or outside it: die that was at [1, 2].",
        "No longer to be seen on the table or in the basket: die that was at [1, 2].",
        "Not found again: die that was at [1, 2].",
    ],
)
def test_what_no_list_will_tell_stays(next_sentence):
    whole = f"Done: x. Also moved: red mug by about 5 cm, to [20, 30]. {next_sentence} "
    whole += "Manipulations left: 9."
    assert ShortResults().shortened("push", whole) == (
        f"Done: x. Others moved, too. {next_sentence} Manipulations left: 9."
    )


def test_what_is_no_list_stays_as_it_is():
    texts, tools = ShortResults(), table()
    refused = tools.call("perceive_scene", {"where": "here"}).text
    assert texts.shortened("perceive_scene", refused) == refused
    without_ids = '# x\nobjects:\n- number: 1\n  description: "a mug"\n  point: [1, 2]\n'
    without_ids += "  box: [0, 0, 3, 3]\nrelations: []\ncluttered: []\nclear: []"
    assert texts.shortened("perceive_scene", without_ids) == without_ids
    earlier = "object_id: object_1\nname: mug\ndescription: A mug."
    assert texts.shortened("find_object", earlier) == earlier


def test_the_last_turn_is_told_after_a_short_list():
    tools, texts = table(), ShortResults()
    for _ in range(TURNS - 1):
        told(tools, texts, "perceive_scene")
    last = told(tools, texts, "perceive_scene")
    assert last == (
        "# Nothing has changed since the last list.\nThis was the last turn; the episode has ended."
    )


def test_an_empty_table_is_told_as_one():
    empty = Toolshed(PaintedStation(()), Oracle(SPECS), Obedient(), UR5_TABLE, pictures=False)
    assert told(empty, ShortResults(), "perceive_scene") == "# Nothing shows."


def test_places_are_counted_after_lists_are_shortened():
    tools, texts = table(), ResultTexts("0-1000", "short")
    listed = texts.told("perceive_scene", tools.call("perceive_scene", {}).text)
    # (159, 159) and 120 of 1024 pixels in thousandths.
    assert "- object_1 at [155, 155]: red mug, object_1, [117, 117]" in listed
