"""What a question wants taken away has to be movable by the hand, on a table with real physics."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import pytest

from boxes import box_library, standing
from probe.assets.tables import table_ids
from probe.generation.movable import immovable, necessary
from probe.render.photograph import load_scene
from probe.render.renderer import Renderer
from probe.tasks.suite_file import packaged_suite
from probe.tasks.task import Task

pytestmark = pytest.mark.slow

LIBRARY = box_library(
    red_block=(0.06, 0.05, 0.06, 190, 40, 40),
    blue_lid=(0.10, 0.09, 0.03, 40, 80, 180),
    green_card=(0.26, 0.24, 0.004, 50, 130, 60),
    white_cube=(0.03, 0.03, 0.03, 235, 235, 235),
)


@pytest.fixture(scope="module")
def renderer() -> Iterator[Renderer]:
    with Renderer() as it:
        yield it


def task(*spots, named=(), targets=()) -> Task:
    frozen = packaged_suite("demo").tasks[0]
    scene = replace(standing(LIBRARY, *spots), table=table_ids(None)[0])
    return replace(frozen, scene=scene, cover=None, named=named, targets=targets)


def test_a_block_goes_and_a_card_that_lies_flat_does_not(renderer):
    spots = [("red_block", -0.1, 0.0, 0.0), ("green_card", 0.1, 0.0, 0.0)]
    assert immovable(task(*spots, named=(1,)), LIBRARY, renderer) is None
    assert immovable(task(*spots, named=(1, 2)), LIBRARY, renderer) == (
        "green card went in 0 of 3 tries"
    )


def test_what_lies_on_a_named_thing_and_is_named_too_goes_first(renderer):
    spots = [("blue_lid", 0.0, 0.0, 0.0), ("red_block", 0.0, 0.0, 0.03)]
    both = task(*spots, named=(1, 2))
    assert immovable(both, LIBRARY, renderer) is None
    assert necessary(both, renderer) == (2, 1)


def test_whatever_hides_a_target_is_necessary(renderer):
    spots = [("white_cube", 0.0, 0.0, 0.0), ("blue_lid", 0.0, 0.0, 0.03), ("red_block", 0.15, 0, 0)]
    hidden = task(*spots, targets=(1,))
    load_scene(renderer, hidden.scene, LIBRARY, LIBRARY.table(hidden.scene.table))
    assert necessary(hidden, renderer) == (2,)
    assert necessary(task(*spots, targets=(3,)), renderer) == ()
