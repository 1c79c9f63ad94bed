"""First looks at painted frames, whose areas and heights are known."""

from dataclasses import replace

import numpy as np
import pytest

from probe.assets.library import Library
from probe.generation.first_look import first_look, look_at
from probe.render.renderer import Renderer
from probe.scene.setup import newest
from probe.tasks.suite_file import demo_suite
from probe.tasks.task import Mark
from tabletops import Block, paint, spec

SPECS = {1: spec("grey slab", "gray"), 2: spec("red box", "red"), 3: spec("green card", "green")}
SLAB = Block(1, (100, 100, 299, 299), height=0.02, colour=(120, 120, 120))
BOX = Block(2, (250, 100, 349, 299), height=0.08, colour=(200, 30, 30))
CARD = Block(3, (600, 600, 639, 619), height=0.01, colour=(30, 120, 40), share=0.1)


def look(*blocks, marks=()):
    return first_look(paint(blocks), SPECS, marks)


def test_what_shows_is_told_with_its_area_and_colour():
    seen = {thing.name: thing for thing in look(SLAB, BOX, CARD).things}
    assert seen["grey slab"].area_px == 150 * 200
    assert seen["red box"].area_px == 100 * 200
    assert seen["red box"].lab == pytest.approx((42.4, 62.4, 45.0), abs=1.0)


def test_what_is_hardly_seen_has_no_name():
    (card,) = [thing for thing in look(SLAB, BOX, CARD).things if thing.name is None]
    assert (card.category, card.area_px, card.colours) == ("", 800, ("green",))
    assert card.box_px == (600, 600, 639, 619)


def test_the_share_of_the_outline_under_something_higher():
    seen = {thing.name: thing for thing in look(SLAB, BOX).things}
    # One of two sides of 200 px, of an outline of 700 px.
    assert seen["grey slab"].overlapped == pytest.approx(200 / 700, abs=0.02)
    assert seen["red box"].overlapped == 0.0


def test_contacts_are_told_but_not_mere_places():
    seen = look(SLAB, BOX, CARD)
    (contact,) = seen.contacts
    names = [thing.name for thing in seen.things]
    assert (names[contact.first], contact.kind, names[contact.second]) == (
        "red box",
        "covering",
        "grey slab",
    )
    slab = names.index("grey slab")
    assert seen.meeting(slab) == (names.index("red box"),)
    assert [thing.name for thing in seen.called("red box")] == ["red box"]


def test_marks_lie_on_what_shows_there():
    marks = (Mark("A", 3, (620, 610)), Mark("B", 1, (150, 150)))
    seen = look(SLAB, BOX, CARD, marks=marks)
    assert seen.things[seen.marked["A"]].area_px == 800
    assert seen.things[seen.marked["B"]].name == "grey slab"


def test_what_is_out_of_sight_leaves_no_trace():
    beneath = Block(3, (260, 150, 300, 200), height=0.01)
    assert look(SLAB, BOX, beneath) == look(SLAB, BOX)


@pytest.mark.slow
def test_it_is_taken_in_the_light_of_the_tasks_pictures(library: Library, renderer: Renderer):
    even = demo_suite().tasks[0]
    room = replace(even, scene=replace(even.scene, setup=newest(even.setup, "day_room", looks=1)))
    looks = [look_at(task, library, renderer) for task in (even, room)]
    boxes = [[thing.box_px for thing in look.things] for look in looks]
    assert boxes[0] == boxes[1]
    lightness = np.array([[thing.lab[0] for thing in look.things] for look in looks])
    assert np.abs(lightness[0] - lightness[1]).max() > 3
