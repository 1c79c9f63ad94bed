"""Two worlds that look the same and are answered otherwise."""

from __future__ import annotations

from dataclasses import replace
from itertools import islice

import numpy as np
import pytest

from probe.assets.library import Library
from probe.generation.paint_twins import PaintTwins
from probe.generation.palettes import main_colour
from probe.generation.plan import plan
from probe.generation.task_plan import CROSSED
from probe.generation.twin_pairs import TwinPair, TwinSide, draw_duels
from probe.question_types.compare.casting import paint_twins_of
from probe.scene.seeds import generator
from probe.tasks.task import Letter
from tabletops import spec

SIDE = np.array([50.0, 0, 0]), np.zeros(1)
CAN = TwinSide(spec("red can", "red"), spec("blue can", "blue"), *SIDE)
JAR = TwinSide(spec("red jar", "red"), spec("gray jar", "gray"), *SIDE)
DUEL = TwinPair(CAN, JAR, None, "red")


@pytest.mark.parametrize("letter", ["A", "B"])
@pytest.mark.parametrize("tells", [True, False])
def test_one_is_right_in_each_world_and_both_look_the_same(letter, tells):
    wanted = CROSSED.put(replace(plan("compare", 0), letter=letter), (letter, tells, True))
    asked = DUEL.asked(wanted)
    right, wrong = asked.marked[asked.right], asked.marked[1 - asked.right]
    assert right.colours == ("red",) and "red" not in wrong.colours
    # Who fits better by what shows is right if that is to tell.
    assert (right.name == "red can") == tells
    assert ("AB"[asked.right]) == letter
    # In the other world the other one is right, and each lies where its twin does.
    assert asked.twins[1 - asked.right].colours == ("red",) != asked.twins[asked.right].colours
    shapes = [[each.name.split()[1] for each in pair] for pair in (asked.marked, asked.twins)]
    assert shapes[0] == shapes[1]
    other: Letter = "B" if letter == "A" else "A"
    opposite = CROSSED.put(replace(wanted, letter=other), (other, not tells, False))
    assert DUEL.asked(opposite).marked == asked.twins


def test_nobody_is_asked_for_a_colour_without_a_meaning(tmp_path):
    cans, jars = (
        PaintTwins(
            (spec(f"one {it}", "magenta"), spec(f"other {it}", "puce")), SIDE[1], SIDE[0][None]
        )
        for it in ("can", "jar")
    )
    nothing_known = Library((), None, tmp_path)
    assert not [*draw_duels(nothing_known, (cans, jars), "colour", generator(0, "t"))]


@pytest.mark.slow
@pytest.mark.parametrize("form", ["colour", "darker", "like"])
def test_duels_of_the_library_are_clear_in_both_worlds(library: Library, form):
    found = list(islice(draw_duels(library, paint_twins_of(library), form, generator(0, "t")), 20))
    assert len({duel.fitting.right.category for duel in found}) >= 4
    for duel in found:
        for right, wrong in (
            (duel.fitting.right, duel.other.wrong),
            (duel.other.right, duel.fitting.wrong),
        ):
            colours = [main_colour(library, each.id) for each in (right, wrong)]
            if form == "darker":
                assert colours[0][0] + 15 <= colours[1][0]
            else:
                asked = duel.word or (duel.third.colours[0] if duel.third else "")
                assert right.colours[0] == asked and asked not in wrong.colours
