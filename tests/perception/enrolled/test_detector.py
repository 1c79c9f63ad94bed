from dataclasses import replace

import numpy as np

from probe.perception.enrolled.detector import EnrolledDetector, once
from probe.perception.enrolled.enrolment import EnrolledWords
from probe.perception.enrolled.enrolment_file import enrolment_of
from probe.perception.enrolled.showing import shown
from probe.perception.matching import match
from probe.perception.segmenter import Segmenter
from tabletops import Block, paint

RED, BLUE, WHITE = (170, 30, 30), (30, 60, 160), (235, 235, 235)
BOX = Block(1, (300, 300, 499, 399), height=0.06, colour=RED)
BAR = Block(2, (600, 300, 639, 699), height=0.03, colour=BLUE)
CUBE = Block(3, (100, 700, 199, 799), height=0.05, colour=BLUE)
KNOWN = {
    EnrolledWords("red box", ("carton",), "A red box."): shown([paint([BOX])]),
    EnrolledWords("blue bar"): shown([paint([BAR])]),
    EnrolledWords("blue cube"): shown([paint([CUBE])]),
}


def detected(*blocks):
    frame = replace(paint(blocks), labels=None, shares=None)
    return EnrolledDetector(enrolment_of(KNOWN), Segmenter()).detect(frame)


def moved(block, du, dv):
    left, top, right, bottom = block.box
    return replace(block, box=(left + du, top + dv, right + du, bottom + dv))


def names(things):
    return {thing.words.name for thing in things}


def test_things_have_their_names_wherever_they_lie():
    things = detected(moved(BOX, -100, 200), moved(BAR, 150, 50), moved(CUBE, 300, -500))
    assert names(things) == {"red box", "blue bar", "blue cube"}
    box = next(thing for thing in things if thing.words.name == "red box")
    assert box.words.description == "A red box." and box.words.colours == ("red",)


def test_a_thing_half_hidden_keeps_its_name():
    over = Block(4, (420, 250, 560, 450), height=0.12, colour=WHITE)
    assert "red box" in names(detected(BOX, over))


def test_what_was_never_shown_is_described():
    (strange,) = detected(Block(4, (300, 300, 420, 420), height=0.05, colour=(240, 210, 60)))
    assert strange.words.name is None
    assert strange.words.description.startswith("something that was not recognised: yellow")


def test_what_is_far_too_large_is_no_known_thing():
    (large,) = detected(Block(4, (200, 200, 700, 600), height=0.06, colour=RED))
    assert large.words.name is None


def test_a_synonym_finds_it_as_well_as_its_name():
    things = detected(BOX, BAR)
    for words in ("red box", "the carton"):
        found = match(words, things)
        assert found is not None and found.thing.words.name == "red box" and found.literal


def test_of_two_that_come_nearest_to_one_object_the_likelier_has_its_name():
    odds = [np.array([3.0, 0.0]), np.array([2.0, -1.0]), np.array([0.4, 0.3]), np.array([-1.0, -9])]
    assert once(odds) == [0, None, None, None]
