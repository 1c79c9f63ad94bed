"""Patches that mislead, and the same ones where they tell."""

from __future__ import annotations

from dataclasses import replace
from itertools import islice

import numpy as np
import pytest

from probe.assets.colours import lab
from probe.certify.leads import Asked
from probe.certify.plan import plan
from probe.certify.rims import Rims, in_shade
from probe.certify.stories import Story, Twins, draw_twins
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


def twins(these: Rims, form: str, seed: int = 0) -> list[Twins]:
    return list(islice(draw_twins(these, form, generator(seed, "test")), 20))  # type: ignore[arg-type]


def stories(these: Rims, form: str, tells: bool) -> list[Story]:
    return [pair.telling if tells else pair.misleading for pair in twins(these, form)]


def asked(these: Rims, pair: Twins, form: str, tells: bool, letter: str) -> Asked:
    cues = tells, True, True
    return pair.asked(these, replace(plan("compare", 0), form=form, cues=cues, letter=letter))  # type: ignore[arg-type]


def named(these: Rims, place: int) -> str:
    return these.specs[place].name


@pytest.mark.parametrize("seed", range(3))
def test_the_same_patches_tell_and_mislead(seed):
    found = twins(ALL, "colour", seed)
    assert len(found) > 10
    for pair in found:
        assert np.array_equal(pair.misleading.patches, pair.telling.patches[::-1])


def test_what_misleads_shows_the_other_ones_colour():
    """Only the jar's grey side is farther from red than the orange ball is."""
    found = stories(ALL, "colour", tells=False)
    assert {(named(ALL, s.right), named(ALL, s.wrong)) for s in found} == {
        ("red jar", "orange ball")
    }
    found = stories(ALL, "colour", tells=True)
    assert {(named(ALL, s.right), named(ALL, s.wrong)) for s in found} == {
        ("red cup", "gray stone")
    }


def test_without_a_twin_that_tells_there_is_nothing():
    lonely = rims(CAPPED, ("orange ball", "orange", (ORANGE,)), ("gray stone", "gray", (GREY,)))
    assert not twins(lonely, "colour")


def test_what_is_asked_names_the_right_one_by_its_letter():
    pair, *_ = twins(ALL, "colour")
    for letter, right in (("A", 0), ("B", 1)):
        it = asked(ALL, pair, "colour", True, letter)
        assert it.right == right and it.word == "red" and it.reference is None
        assert it.marked[right].name == "red cup" and it.marked[1 - right].name == "gray stone"
        assert np.array_equal(it.patches[right], pair.telling.patches[0])


def test_twins_show_the_same_under_the_same_letters_if_answered_by_opposite_ones():
    pair, *_ = twins(ALL, "colour")
    telling, misleading = (
        asked(ALL, pair, "colour", True, "A"),
        asked(ALL, pair, "colour", False, "B"),
    )
    assert np.array_equal(telling.patches, misleading.patches)
    assert misleading.marked[1].name == named(ALL, pair.misleading.right)


def test_likeness_is_to_a_third_thing_that_both_stories_share():
    more = rims(
        CAPPED,
        ("red cup", "red", (ORANGE, RED)),
        ("orange ball", "orange", (ORANGE,)),
        ("gray stone", "gray", (GREY,)),
        ("red pen", "red", (RED,)),
    )
    found = twins(more, "like")
    assert found and all(pair.misleading.third == pair.telling.third for pair in found)
    for pair in found:
        for tells, story in ((False, pair.misleading), (True, pair.telling)):
            reference = asked(more, pair, "like", tells, "A").reference
            assert reference is not None and reference.colours == ("red",)
            assert story.third not in (story.right, story.wrong)


def test_darker_misleads_by_lightness():
    dark = rims(
        ("black bottle", "black", (BLACK, GREY)),
        ("red cup", "red", (RED,)),
        ("gray stone", "gray", (GREY,)),
        ("red pen", "red", (RED,)),
    )
    found = stories(dark, "darker", tells=False)
    assert found
    for story in found:
        assert named(dark, story.right) == "black bottle"
        right, wrong = story.patches
        assert right[0] - wrong[0] >= 16


def test_odd_sides_and_those_that_show_a_colour():
    assert [named(ALL, place) for place in ALL.odd()] == ["red jar", "red cup"]
    grey = in_shade(lab(np.array([GREY]))[0])
    assert [named(ALL, place) for place in ALL.showing(grey)] == ["red jar", "gray stone"]
    within, beyond = grey + (3, 0, 0), grey + (8, 0, 0)
    assert [named(ALL, place) for place in ALL.showing(within)] == ["red jar", "gray stone"]
    assert len(ALL.showing(beyond)) == 0, "a picture would tell them apart"
    assert len(ALL.facing(0, beyond)) == 0


def test_what_is_asked_says_which_sides_look_out():
    pair, *_ = twins(ALL, "colour")
    it = asked(ALL, pair, "colour", False, "B")
    assert it.marked[it.right].name == "red jar"
    assert [list(angles) for angles in it.facing][it.right] == [2.0], "its third side is grey"
