"""Patches that mislead, and the same ones where they tell."""

from __future__ import annotations

from dataclasses import replace
from itertools import islice

import numpy as np
import pytest

from probe.assets.colours import lab
from probe.certify.plan import plan
from probe.certify.rims import NEAR, Rims, in_shade
from probe.certify.stories import draw_stories
from probe.scene.seeds import generator
from tabletops import spec

RED, ORANGE, GREY, BLACK = (195, 42, 42), (230, 120, 40), (160, 160, 160), (35, 35, 36)
RGB = {"red": RED, "orange": ORANGE, "gray": GREY, "black": BLACK}


def rims(*things: tuple[str, str, tuple[tuple[int, int, int], ...]]) -> Rims:
    """Of things by name: their main colour's name, and what their sides show."""
    sides = [lab(np.array(shown)) for _, _, shown in things]
    return Rims(
        tuple(spec(name, colour) for name, colour, _ in things),
        lab(np.array([RGB[colour] for _, colour, _ in things])),
        np.repeat(np.arange(len(things)), [len(found) for found in sides]),
        np.concatenate([np.arange(len(found)) for found in sides]).astype(float),
        in_shade(np.concatenate(sides)),
    )


CAPPED = ("red jar", "red", (RED, RED, GREY))
ALL = rims(
    CAPPED,
    ("red cup", "red", (ORANGE, RED)),
    ("orange ball", "orange", (ORANGE,)),
    ("gray stone", "gray", (GREY,)),
)


def stories(these: Rims, form: str, tells: bool, seed: int = 0):
    wanted = replace(plan("compare", 0), form=form, cues=(tells, True, True))  # type: ignore[arg-type]
    drawn = draw_stories(these, wanted, generator(seed, "test"))
    return wanted, list(islice(drawn, 20))


def named(these: Rims, place: int) -> str:
    return these.specs[place].name


@pytest.mark.parametrize("seed", range(3))
def test_the_same_patches_tell_and_mislead(seed):
    (_, misleading), (_, telling) = (stories(ALL, "colour", tells, seed) for tells in (False, True))
    assert len(misleading) == len(telling) > 10
    for one, other in zip(misleading, telling, strict=True):
        assert np.array_equal(one.patches, other.patches[::-1])


def test_what_misleads_shows_the_other_ones_colour():
    """Only the jar's grey side is farther from red than the orange ball is."""
    _, found = stories(ALL, "colour", tells=False)
    assert {(named(ALL, s.right), named(ALL, s.wrong)) for s in found} == {
        ("red jar", "orange ball")
    }
    _, found = stories(ALL, "colour", tells=True)
    assert {(named(ALL, s.right), named(ALL, s.wrong)) for s in found} == {
        ("red cup", "gray stone")
    }


def test_without_a_twin_that_tells_there_is_nothing():
    lonely = rims(CAPPED, ("orange ball", "orange", (ORANGE,)), ("gray stone", "gray", (GREY,)))
    for tells in (False, True):
        assert not stories(lonely, "colour", tells)[1]


def test_what_is_asked_names_the_right_one_by_its_letter():
    wanted, (story, *_) = stories(ALL, "colour", tells=True)
    for letter, right in (("A", 0), ("B", 1)):
        asked = story.asked(ALL, replace(wanted, letter=letter))
        assert asked.right == right and asked.word == "red" and asked.reference is None
        assert (
            asked.marked[right].name == "red cup" and asked.marked[1 - right].name == "gray stone"
        )
        assert np.array_equal(asked.patches[right], story.patches[0])


def test_likeness_is_to_a_third_thing_that_both_stories_share():
    more = rims(
        CAPPED,
        ("red cup", "red", (ORANGE, RED)),
        ("orange ball", "orange", (ORANGE,)),
        ("gray stone", "gray", (GREY,)),
        ("red pen", "red", (RED,)),
    )
    (wanted, misleading), (_, telling) = (stories(more, "like", tells) for tells in (False, True))
    assert misleading and [s.third for s in misleading] == [s.third for s in telling]
    for story in (*misleading, *telling):
        reference = story.asked(more, wanted).reference
        assert reference is not None and reference.colours == ("red",)
        assert story.third not in (story.right, story.wrong)


def test_darker_misleads_by_lightness():
    dark = rims(
        ("black bottle", "black", (BLACK, GREY)),
        ("red cup", "red", (RED,)),
        ("gray stone", "gray", (GREY,)),
        ("red pen", "red", (RED,)),
    )
    _, found = stories(dark, "darker", tells=False)
    assert found
    for story in found:
        assert named(dark, story.right) == "black bottle"
        right, wrong = story.patches
        assert right[0] - wrong[0] >= 16


def test_odd_sides_and_those_that_show_a_colour():
    assert [named(ALL, place) for place in ALL.odd()] == ["red jar", "red cup"]
    grey = in_shade(lab(np.array([GREY]))[0])
    assert [named(ALL, place) for place in ALL.showing(grey)] == ["red jar", "gray stone"]
    assert len(ALL.showing(grey + (2 * NEAR, 0, 0))) == 0


def test_what_is_asked_says_which_sides_look_out():
    wanted, (story, *_) = stories(ALL, "colour", tells=False)
    asked = story.asked(ALL, wanted)
    assert asked.marked[asked.right].name == "red jar"
    assert [list(angles) for angles in asked.facing][asked.right] == [2.0], "its third side is grey"
