"""The fewest things that have to go before an answer shows, on tables with real physics."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import pytest

from boxes import box_library, standing
from probe.assets.tables import table_ids
from probe.generation.necessary import RemovalSearch, necessary_removals
from probe.render.renderer import Renderer
from probe.tasks.suite_file import packaged_suite
from probe.tasks.task import NONE_OF_THE_ABOVE, Option, Task

pytestmark = pytest.mark.slow

LIBRARY = box_library(
    white_cube=(0.03, 0.03, 0.03, 235, 235, 235),
    black_cube=(0.03, 0.03, 0.03, 35, 35, 35),
    blue_lid=(0.10, 0.09, 0.03, 40, 80, 180),
    green_lid=(0.08, 0.06, 0.02, 50, 130, 60),
    gray_lid=(0.04, 0.06, 0.02, 120, 120, 120),
    brown_board=(0.18, 0.16, 0.01, 110, 70, 40),
    pink_bar=(0.12, 0.03, 0.03, 240, 150, 180),
)
CUBE = ("white_cube", 0.0, 0.0, 0.0)
LID = ("blue_lid", 0.0, 0.0, 0.03)
BOARD = ("brown_board", 0.0, 0.0, 0.06)
BESIDE = ("black_cube", 0.15, 0.1, 0.0)


@pytest.fixture(scope="module")
def renderer() -> Iterator[Renderer]:
    with Renderer() as it:
        yield it


def task(*spots, question_type="beneath", named=(), targets=(1,), answer="A") -> Task:
    scene = replace(standing(LIBRARY, *spots), table=table_ids(None)[0])
    options = (Option("A", "white cube"), Option("E", NONE_OF_THE_ABOVE))
    return replace(
        packaged_suite("demo").tasks[0],
        question_type=question_type,
        scene=scene,
        cover=None,
        named=named,
        targets=targets,
        marks=(),
        options=options,
        answer=answer,
    )


def fewest(renderer: Renderer, *spots, evidence=(1,)) -> tuple[int, ...] | None:
    return RemovalSearch.of(task(*spots), LIBRARY, renderer).fewest(evidence)


def test_what_shows_needs_nothing(renderer):
    assert fewest(renderer, CUBE, BESIDE) == ()


def test_one_cover_is_one_removal_and_a_cover_on_that_another(renderer):
    assert fewest(renderer, CUBE, LID, BESIDE) == (2,)
    assert fewest(renderer, CUBE, LID, BOARD, BESIDE) == (2, 3)


def test_of_two_that_hide_a_part_each_the_one_that_hides_more_will_do(renderer):
    bar, lids = ("pink_bar", 0, 0, 0), [("gray_lid", 0.04, 0, 0.03), ("green_lid", -0.02, 0, 0.03)]
    assert fewest(renderer, bar, *lids) == (3,)


def test_all_that_decides_has_to_show(renderer):
    other = [("black_cube", 0.2, 0.0, 0.0), ("green_lid", 0.2, 0.0, 0.03)]
    assert fewest(renderer, CUBE, LID, *other, evidence=(1, 3)) == (2, 4)


def test_what_falls_onto_it_once_its_cover_is_gone_has_to_go_as_well(renderer):
    # The board leans on nothing but the lid beside the cube, and tips over onto it.
    spots = [
        ("white_cube", 0.075, 0.0, 0.0),
        ("blue_lid", 0.0, 0.0, 0.0),
        ("brown_board", 0.0, 0.0, 0.03),
    ]
    assert fewest(renderer, *spots) == (3,)


@pytest.mark.parametrize("question_type", ["exact", "reduce"])
def test_what_the_question_wants_removed_is_part_of_it(renderer, question_type):
    asked = task(CUBE, LID, BESIDE, question_type=question_type, named=(3,))
    assert necessary_removals(asked, LIBRARY, renderer) == (2, 3)


def test_a_number_is_known_once_the_whole_table_shows(renderer):
    other = [("pink_bar", -0.2, 0.0, 0.0), ("brown_board", -0.2, 0.0, 0.03)]
    counted = task(CUBE, LID, *other, question_type="count", targets=(1,))
    assert necessary_removals(counted, LIBRARY, renderer) == (2, 4)
    bare = task(CUBE, BESIDE, question_type="count", targets=(1,))
    assert necessary_removals(bare, LIBRARY, renderer) == ()


def test_none_of_them_is_known_once_all_copies_of_the_cover_are_gone(renderer):
    copy = [("black_cube", 0.2, 0.0, 0.0), ("blue_lid", 0.2, 0.0, 0.03)]
    other = [("pink_bar", -0.2, 0.0, 0.0), ("brown_board", -0.2, 0.0, 0.03)]
    listed = replace(task(CUBE, LID, *copy, *other, question_type="decoys"), cover=2)
    assert necessary_removals(listed, LIBRARY, renderer) == (2,)
    assert necessary_removals(replace(listed, answer="E"), LIBRARY, renderer) == (2, 4)
    beneath = replace(listed, question_type="beneath", answer="E")
    assert necessary_removals(beneath, LIBRARY, renderer) == (2,)


def test_none_of_them_is_known_once_the_whole_table_shows(renderer):
    other = [("pink_bar", -0.2, 0.0, 0.0), ("brown_board", -0.2, 0.0, 0.03)]
    listed = task(CUBE, LID, *other, question_type="find")
    assert necessary_removals(listed, LIBRARY, renderer) == (2,)
    assert necessary_removals(replace(listed, answer="E"), LIBRARY, renderer) == (2, 4)
