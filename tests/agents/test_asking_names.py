"""Where lists tell kinds alone, the scripted agent asks by name, and no more than it must."""

from __future__ import annotations

import numpy as np
import pytest

from probe.agents.asking_names import KnownNames, names_in
from probe.agents.scripted import Scripted
from probe.episodes.turns import Question
from probe.perception.dials import Dials
from tabletops import Block, spec

SPECS = {
    1: spec("blue bowl", "blue"),
    2: spec("red lime", "red", category="lime"),
    3: spec("yellow lemon", "yellow", category="lemon"),
    4: spec("green book", "green"),
    5: spec("red lime", "red", category="lime"),
}
COVER = Block(1, (300, 300, 499, 499), 0.08, (30, 60, 150))
BOOK = Block(4, (700, 100, 899, 299), 0.03, (40, 120, 50))
LEMON = Block(3, (100, 700, 199, 799), 0.03, (220, 200, 40))
FRUIT = ["red lime", "yellow lemon", "green apple", "orange plum", "None of the above"]
COARSE = Dials(general=1.0)


def under(instance: int) -> Block:
    return Block(instance, (370, 370, 429, 429), 0.02, (180, 40, 40))


def beneath() -> Scripted:
    return Scripted("beneath", "blue bowl", np.random.default_rng(5))


def called(record) -> list[str]:
    """Names that were asked for; places aside."""
    asked = [step.call.values.get("description", "") for step in record.steps]
    return [text for text in asked if text and not text.startswith("the thing at")]


@pytest.mark.parametrize(("hidden", "letter"), [(2, "A"), (3, "B")])
def test_what_comes_to_light_is_asked_for_by_name(play, hidden, letter):
    record = play(beneath(), FRUIT, SPECS, [COVER, BOOK, under(hidden)], dials=COARSE)
    assert record.answer and record.answer.choice == letter
    lists = [step.text for step in record.steps if step.call.name == "perceive_scene"]
    assert all("lime" not in text and "lemon" not in text for text in lists)
    assert 'name: "fruit"' in lists[-1]


def test_names_are_asked_for_only_where_something_new_of_their_kind_shows(play):
    record = play(beneath(), FRUIT, SPECS, [COVER, BOOK, under(2)], dials=COARSE)
    assert called(record) == ["blue bowl", *FRUIT[:4]]
    again = play(beneath(), ["red cup", *FRUIT[1:]], SPECS, [COVER, BOOK, under(2)], dials=COARSE)
    assert "red cup" not in called(again)  # nothing of its kind came to light
    plain = play(beneath(), FRUIT, SPECS, [COVER, BOOK, under(2)])
    assert called(plain) == []


def test_what_shows_from_the_start_is_not_what_came_to_light(play):
    record = play(beneath(), FRUIT, SPECS, [COVER, BOOK, LEMON, under(2)], dials=COARSE)
    assert record.answer and record.answer.choice == "A"


def test_none_of_them_is_said_of_what_goes_by_no_option(play):
    options = ["green apple", "orange plum", "brown pear", "red cup", "None of the above"]
    record = play(beneath(), options, SPECS, [COVER, BOOK, under(3)], dials=COARSE)
    assert record.answer and record.answer.choice == "E"


def test_like_things_are_counted(play):
    agent = Scripted("count", "red lime", np.random.default_rng(5))
    blocks = [COVER, under(2), Block(5, (700, 700, 759, 759), 0.02, (180, 40, 40))]
    record = play(agent, ["1", "2", "3", "4", "5"], SPECS, blocks, dials=COARSE)
    assert record.answer and record.answer.choice == "B"


def test_a_thing_that_has_moved_is_not_taken_for_a_named_one_of_its_kind():
    """A car that was found by name has gone, and something else that is a toy has moved."""

    def listed(*ids: int) -> str:
        entries = (f'- number: 1\n  object_id: object_{id}\n  name: "toy"\n' for id in ids)
        return "objects:\n" + "".join(entries)

    def told(text: str, found: str) -> str:
        asking = known.told(text)
        try:
            next(asking)
            while True:
                asking.send(found)
        except StopIteration as done:
            return done.value

    known = KnownNames(["toy car"])
    assert '"toy car"' in told(listed(1, 2), "object_id: object_1\n")
    assert '"toy object_2"' in told(listed(1, 2), "")
    known.moved |= {"object_3"}
    after = told(listed(3), "Nothing that shows is called that.")
    assert '"toy object_2"' in after and "toy car" not in after


def test_only_names_of_things_are_asked_for():
    options = (("A", "A at (1, 2)"), ("B", "3"), ("C", "small lime"), ("D", "None of the above"))
    asked = Question("What is next to the bell that hid the red golf ball, or a lime?", options)
    fixed = ["What is next to the {cover} that hid this?"]
    assert names_in(asked, "light red, blue bowl", fixed) == [
        *("bell", "golf ball", "blue bowl", "small lime"),
    ]
    assert "bell" not in names_in(asked, "", [*fixed, "What was under the bell?"])


def test_a_longer_name_decides_where_several_fit(play):
    specs = {**SPECS, 2: spec("sweet potato", "red"), 3: spec("potato", "red")}
    options = ["potato", "sweet potato", "green apple", "brown pear", "None of the above"]
    for hidden, letter in ((2, "B"), (3, "A")):
        record = play(beneath(), options, specs, [COVER, BOOK, under(hidden)], dials=COARSE)
        assert record.answer and record.answer.choice == letter


@pytest.mark.parametrize("name", ["goldfish", "yellow softball", "gizmo"])
def test_names_that_are_of_no_known_kind_are_asked_for_whenever_something_is_new(play, name):
    category = "gizmo" if name == "gizmo" else "fish" if name == "goldfish" else "baseball"
    specs = {**SPECS, 2: spec(name, "red", category=category)}
    options = [name, "red cup", "green apple", "brown pear", "None of the above"]
    record = play(beneath(), options, specs, [COVER, BOOK, under(2)], dials=COARSE)
    assert record.answer and record.answer.choice == "A"


def test_what_a_push_has_moved_is_known_again(play):
    agent = Scripted("count", "red lime", np.random.default_rng(5), "push")
    blocks = [COVER, under(2), Block(5, (700, 700, 759, 759), 0.02, (180, 40, 40))]
    record = play(agent, ["1", "2", "3", "4", "5"], SPECS, blocks, dials=COARSE)
    assert record.answer and record.answer.choice == "B"
