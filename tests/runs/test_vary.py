"""Tasks of boxes under other conditions, really settled and drawn."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from boxes import box_library, standing
from probe.assets.tables import load_table
from probe.episodes.conditions import Conditions
from probe.render.photograph import load_scene, measure, photograph
from probe.render.renderer import Renderer
from probe.runs.jitter import jitter
from probe.runs.vary import vary
from probe.runs.viewpoints import camera_of, viewpoint_of
from probe.scene.setup import UR5_TABLE
from probe.scene.viewpoint import Viewpoint
from probe.tasks.suite_file import demo_suite
from probe.tasks.task import Certificate, Mark

LIBRARY = box_library(
    red_box=(0.10, 0.10, 0.04, 200, 40, 40),
    blue_box=(0.06, 0.05, 0.03, 40, 40, 200),
    green_box=(0.12, 0.10, 0.03, 40, 200, 40),
)
# The blue box stands on the red one; the green one alone.
SPOTS = [("red_box", 0.0, 0.0, 0.0), ("blue_box", 0.0, 0.0, 0.04), ("green_box", 0.15, 0.1, 0.0)]
SCENE = replace(standing(LIBRARY, *SPOTS), table="oak_planks", seed=5)
TASK = replace(
    demo_suite().tasks[0],
    question_type="size",
    seed=5,
    question="Which is longer? The marks: A at (512, 512) and B at (777, 335).",
    scene=SCENE,
    targets=(2, 3),
    cover=None,
    marks=(Mark("A", 2, (512, 512)), Mark("B", 3, (777, 335))),
)


@pytest.fixture(scope="module")
def renderer():
    with Renderer() as it:
        yield it


@pytest.fixture(scope="module")
def task(renderer):
    """The task with what is really seen of its things."""
    load_scene(renderer, SCENE, LIBRARY, load_table(SCENE.table, None))
    return replace(TASK, certificate=Certificate(measure(renderer, SCENE), {}, ()))


@pytest.mark.slow
def test_another_table_changes_nothing_else(task, renderer):
    (made,) = vary([task], Conditions(table="other"), LIBRARY, renderer)
    assert made.task.scene.table != "oak_planks" and made.note is None
    assert replace(made.task, scene=SCENE) == task
    assert [made] == list(vary([task], Conditions(table="other"), LIBRARY, renderer))


@pytest.mark.slow
def test_marks_follow_the_camera(task, renderer):
    conditions = Conditions(camera="moved")
    (made,) = vary([task], conditions, LIBRARY, renderer)
    camera = camera_of(task, "moved")
    assert camera != UR5_TABLE.camera()
    labels = photograph(renderer, made.task.scene, rgb=False, camera=camera).labels
    assert labels is not None
    for mark in made.task.marks:
        u, v = mark.point
        assert labels[v, u] == mark.instance
        assert f"{mark.letter} at ({u}, {v})" in made.task.question
    assert made.task.question.startswith("Which is longer? The marks: A at (")
    assert made.task.scene == SCENE
    # Both show whole, which was no rule of a marked thing before either.
    assert made.note is None


def test_small_moves_are_small_and_at_rest():
    moved = jitter(SCENE, 0.003, LIBRARY)
    assert moved is not None and moved == jitter(SCENE, 0.003, LIBRARY)
    for one, other in zip(SCENE.objects, moved.objects, strict=True):
        apart = np.abs(np.subtract(other.pose.position, one.pose.position))
        assert 0 < apart.max() <= 0.0035
    assert moved[2].pose.position[2] == pytest.approx(0.04, abs=0.002)


def test_what_would_fall_is_left_as_it_is():
    # The middle of the upper box lies beyond the edge of the lower one.
    spots = [("red_box", 0.0, 0.0, 0.0), ("green_box", 0.06, 0.0, 0.04)]
    assert jitter(replace(standing(LIBRARY, *spots), seed=5), 0.003, LIBRARY) is None


def test_the_usual_sight_is_the_default():
    assert viewpoint_of(TASK, Conditions(), None) == Viewpoint()


def test_light_is_drawn_for_each_task():
    hdri = Conditions(lighting="hdri")
    found = {viewpoint_of(replace(TASK, seed=seed), hdri, None).lighting for seed in range(5)}
    assert len(found) == 5
    assert viewpoint_of(TASK, hdri, None) == viewpoint_of(TASK, hdri, None)
