from __future__ import annotations

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from probe.scene.scene import PlacedObject, Scene
from probe.scene.setup import UR5_TABLE
from probe.tasks.grading import FinalAnswer, LastView, Score, distance_px, grade, whereabouts
from probe.types import Pose
from task_examples import FIND, SCENE, with_answer

ROWS, COLUMNS = slice(40, 60), slice(100, 130)
"""Where the target shows at the end."""


def last(rows=ROWS, columns=COLUMNS, position=(0.1, 0.2, 0.0), labels_of=2) -> LastView:
    """A last picture in which the target covers some rows and columns."""
    labels = np.zeros((200, 200), np.int32)
    labels[rows, columns] = labels_of
    placed = tuple(
        PlacedObject(2, o.object_id, Pose(position)) if o.instance == 2 else o
        for o in SCENE.objects
    )
    return LastView(labels, Scene(7, "oak", placed))


RIGHT = Score(True, True, "right")
WRONG = Score(False, False, "wrong")


@pytest.mark.parametrize(
    ("answer", "seen", "score"),
    [
        (FinalAnswer("B", (115, 50)), last(), RIGHT),
        (FinalAnswer("B", (98.0, 50)), last(), RIGHT),  # two pixels beside the edge
        (FinalAnswer("B", (97.9, 50)), last(), Score(False, True, "missed")),
        (FinalAnswer("B", (132.0, 50)), last(), RIGHT),
        (FinalAnswer("B", (132.1, 50)), last(), Score(False, True, "missed")),
        (
            FinalAnswer("B", (98.5, 38.5)),
            last(),
            Score(False, True, "missed"),
        ),  # 2.1 px off a corner
        (FinalAnswer("B", (98.6, 38.6)), last(), RIGHT),
        (FinalAnswer("B", (math.nan, 50)), last(), Score(False, True, "missed")),
        (FinalAnswer("B", (math.inf, 50)), last(), Score(False, True, "missed")),
        (FinalAnswer("B"), last(), Score(False, True, "no point")),
        (FinalAnswer("C", (115, 50)), last(), WRONG),
        (FinalAnswer("E", (115, 50)), last(), WRONG),
        (FinalAnswer(None), last(), Score(False, False, "unanswered")),
        (FinalAnswer(None, (115, 50)), last(), Score(False, False, "unanswered")),
        # Stale: right when the target was still there, but it has been moved since.
        (FinalAnswer("B", (115, 50)), last(columns=slice(150, 180)), Score(False, True, "missed")),
        (FinalAnswer("B", (165, 50)), last(columns=slice(150, 180)), RIGHT),
        # In the basket, on the floor.
        (
            FinalAnswer("B", (115, 50)),
            last(position=(-0.5, -0.45, 0.02)),
            Score(False, True, "lost"),
        ),
        (FinalAnswer("B", (115, 50)), last(position=(0.9, 0.0, -0.75)), Score(False, True, "lost")),
        # 24 and 25 visible pixels.
        (
            FinalAnswer("B", (101, 41)),
            last(slice(40, 44), slice(100, 106)),
            Score(False, True, "covered"),
        ),
        (FinalAnswer("B", (101, 41)), last(slice(40, 45), slice(100, 105)), RIGHT),
        (FinalAnswer("B", (115, 50)), last(labels_of=3), Score(False, True, "covered")),
    ],
)
def test_find_where_the_target_is_listed(answer, seen, score):
    assert grade(FIND, answer, seen) == score


@pytest.mark.parametrize("point", [None, (0, 0), (115, 50)])
def test_find_where_none_is_listed_ignores_points(point):
    assert grade(with_answer("E"), FinalAnswer("E", point), last()) == RIGHT
    assert grade(with_answer("E"), FinalAnswer("B", point), last()) == WRONG


@pytest.mark.parametrize("question_type", ["beneath", "count"])
@pytest.mark.parametrize("position", [(0.1, 0.2, 0.0), (-0.5, -0.5, 0.02), (2.0, 0.0, -0.75)])
def test_other_types_look_at_the_letter_alone(question_type, position):
    task = replace(FIND, question_type=question_type)
    seen = last(position=position)
    assert grade(task, FinalAnswer("B"), seen) == RIGHT
    assert grade(task, FinalAnswer("A", (115, 50)), seen) == WRONG
    assert grade(task, FinalAnswer(None), seen).outcome == "unanswered"


MUG, LIME, LEMON = 1, 2, 3
BASKET, FLOOR = (-0.5, -0.45, 0.02), (0.9, 0.0, -0.75)
EXACT = replace(FIND, question_type="exact", named=(MUG,))


def table(**places: tuple[float, float, float]) -> LastView:
    """The table of the start with some things elsewhere, by name."""
    moved = {{"mug": MUG, "lime": LIME, "lemon": LEMON}[name]: at for name, at in places.items()}
    placed = tuple(
        replace(o, pose=replace(o.pose, position=moved.get(o.instance, o.pose.position)))
        for o in SCENE.objects
    )
    return LastView(np.zeros((0, 0), np.int32), Scene(7, "oak", placed))


@pytest.mark.parametrize(
    ("end", "outcome"),
    [
        (table(mug=BASKET), "right"),
        (table(), "not removed"),
        (table(mug=FLOOR), "not removed"),
        (table(mug=(0.3, 0.0, 0.0)), "not removed"),
        (table(mug=BASKET, lemon=BASKET), "others removed"),
        (table(mug=BASKET, lime=FLOOR), "others removed"),
        (table(mug=BASKET, lemon=(-0.1, 0.099, 0.02)), "right"),
        (table(mug=BASKET, lemon=(-0.1, 0.101, 0.02)), "others moved"),
        (table(mug=BASKET, lemon=(-0.1, 0.05, 0.08)), "others moved"),
        (table(mug=BASKET, lime=(0.1 + 0.06, 1 / 3, 0.02)), "others moved"),
    ],
)
def test_exact_grades_the_table_as_well(end, outcome):
    assert grade(EXACT, FinalAnswer("B"), end) == Score(outcome == "right", True, outcome)
    assert grade(EXACT, FinalAnswer("A"), end) == WRONG
    assert grade(EXACT, FinalAnswer(None), end).outcome == "unanswered"
    none = replace(EXACT, answer="E")
    assert grade(none, FinalAnswer("E"), end) == Score(outcome == "right", True, outcome)


@pytest.mark.parametrize(
    ("position", "place"),
    [
        ((0.0, 0.0, 0.0), "table"),
        ((0.75, 0.65, 0.1), "table"),
        ((0.81, 0.0, 0.1), "off the table"),
        ((0.0, 0.0, -0.7), "off the table"),
        ((-0.55, -0.44, 0.01), "basket"),
        ((-0.71, -0.27, 0.3), "basket"),
        ((-0.36, -0.44, 0.0), "table"),
        ((-0.55, -0.25, 0.01), "table"),
        ((-0.55, -0.63, 0.01), "table"),
        ((-0.55, -0.44, -0.019), "basket"),
        ((-0.55, -0.44, -0.021), "off the table"),
        ((0.0, 0.0, -0.019), "table"),
        ((0.0, 0.0, -0.021), "off the table"),
        ((0.0, 0.71, 0.1), "off the table"),
        ((0.0, -0.71, 0.1), "off the table"),
        ((-0.81, 0.0, 0.1), "off the table"),
    ],
)
def test_whereabouts(position, place):
    assert whereabouts(Pose(position), UR5_TABLE) == place


@given(st.floats(-20, 60), st.floats(-20, 60))
def test_distance_is_that_to_the_nearest_corner_or_side(u, v):
    mask = np.zeros((40, 40), dtype=bool)
    mask[10:20, 5:25] = True
    nearest = min(max(u, 5), 25), min(max(v, 10), 20)
    assert distance_px(mask, (u, v)) == pytest.approx(math.dist((u, v), nearest))


def test_nothing_is_near_an_empty_mask():
    assert distance_px(np.zeros((4, 4), dtype=bool), (1, 1)) == math.inf
