"""The observer's rules on looks that are made by hand."""

from dataclasses import replace

import pytest

from probe.generation.first_look import FirstLook, VisibleThing
from probe.generation.observer import observe, visible_count
from probe.perception.colour_words import colour_words_in, colours_in
from probe.perception.scene_graph import Relation

RED, BLUE, DARK = (45.0, 60.0, 40.0), (40.0, 10.0, -50.0), (12.0, 0.0, 0.0)
THING = VisibleThing("red mug", "mug", ("red",), 5000, (100, 100, 199, 199), RED, 0.0, 0.05, 0.0)
PATCH = replace(THING, name=None, category="", area_px=400)
OPTIONS = ("blue brick", "red egg", "green die", "black pawn", "None of the above")
PAIR = ("Object A", "Object B")


def named(name: str, **changes) -> VisibleThing:
    return replace(THING, name=name, **changes)


def marked(a: VisibleThing, b: VisibleThing, *others: VisibleThing) -> FirstLook:
    return FirstLook((a, b, *others), (), {"A": 0, "B": 1})


@pytest.mark.parametrize(
    "question", ["How many red mugs were there?", "Of all, are they red mugs?"]
)
def test_it_counts_what_it_sees(question):
    look = FirstLook((THING, THING, named("red mug lid"), PATCH), (), {})
    assert visible_count(question, look) == 2
    assert observe("count", "plain", question, ("0", "2", "4", "5", OPTIONS[-1]), look) == "B"
    assert observe("count", "plain", question, ("0", "3", "4", "5", OPTIONS[-1]), look) == "E"


def test_what_it_does_not_see_is_none():
    assert visible_count("How many white eggs?", FirstLook((THING,), (), {})) == 0


def test_find_goes_by_the_colour_of_what_is_half_hidden():
    look = FirstLook((THING, replace(PATCH, lab=BLUE)), (), {})
    assert observe("find", "plain", "Which is there?", OPTIONS, look) == "A"
    assert observe("find", "plain", "Which is there?", OPTIONS, FirstLook((THING,), (), {})) == "E"


@pytest.mark.parametrize("question_type", ["beneath", "reduce"])
def test_only_what_touches_the_named_thing_matters(question_type):
    things = (named("tray"), replace(PATCH, lab=BLUE), replace(PATCH, lab=RED))
    look = FirstLook(things, (Relation(0, "covering", 2),), {})
    assert observe(question_type, "plain", "What is under the tray?", OPTIONS, look) == "B"


def test_size_goes_by_area_or_box():
    a = replace(PATCH, area_px=900, box_px=(0, 0, 29, 29))
    b = replace(PATCH, area_px=600, box_px=(0, 0, 299, 4))
    assert observe("size", "larger", "?", PAIR, marked(a, b)) == "A"
    assert observe("size", "smaller", "?", PAIR, marked(a, b)) == "B"
    assert observe("size", "longer", "?", PAIR, marked(a, b)) == "B"


def test_compare_goes_by_the_patches():
    a, b = replace(PATCH, lab=BLUE), replace(PATCH, lab=DARK)
    assert observe("compare", "darker", "Which is darker?", PAIR, marked(a, b)) == "B"
    assert observe("compare", "colour", "Which is mainly blue?", PAIR, marked(a, b)) == "A"
    like = "Which one goes with the old hat by its main colour?"
    hat = named("old hat", lab=DARK)
    assert observe("compare", "like", like, PAIR, marked(a, b, hat)) == "B"


def test_shades_are_lighter_and_darker():
    light, plain, dark = colours_in("light blue, blue and dark blue")
    assert light[0] > plain[0] > dark[0]
    assert colours_in("a bluebell") == ()
    assert colour_words_in("Light blue and red bluebell") == {"light blue", "red"}
