"""What is shown of boxes whose places are known; each kind of task."""

from dataclasses import replace

import numpy as np
import pytest

from boxes import box_library, standing
from probe.episodes.oracle_view import oracle_view
from probe.render.photograph import measure, photograph
from probe.render.renderer import Renderer
from probe.tasks.task import Mark
from task_examples import FIND

LIBRARY = box_library(
    red_lid=(0.14, 0.14, 0.02, 190, 40, 40),
    green_lid=(0.16, 0.16, 0.01, 40, 140, 60),
    white_cube=(0.04, 0.04, 0.03, 235, 235, 235),
    black_slab=(0.05, 0.04, 0.02, 30, 30, 30),
    blue_card=(0.2, 0.05, 0.01, 40, 80, 180),
)
LID, TOP, CUBE, SLAB, CARD = 1, 2, 3, 4, 5
SCENE = replace(
    standing(
        LIBRARY,
        ("red_lid", 0.1, 0.1, 0.04),
        ("green_lid", 0.1, 0.1, 0.07),
        ("white_cube", 0.1, 0.1, 0.0),
        ("black_slab", -0.1, -0.1, 0.0),
        ("blue_card", -0.03, -0.1, 0.03),
    ),
    table="linen",
)
MARKS = (Mark("A", SLAB, (300, 680)), Mark("B", LID, (650, 300)))
TASKS = {
    "beneath": replace(FIND, question_type="beneath", targets=(LID,), cover=TOP),
    "reduce": replace(FIND, question_type="reduce", targets=(CUBE,), named=(TOP, LID)),
    "find": replace(FIND, targets=(CUBE,)),
    "count": replace(FIND, question_type="count", targets=(CARD,)),
    "size": replace(FIND, question_type="size", targets=(SLAB, LID), marks=MARKS),
    "compare": replace(FIND, question_type="compare", targets=(SLAB, LID), marks=MARKS),
}
REMOVED = {
    "beneath": (TOP,),
    "reduce": (LID, TOP),
    "find": (LID, TOP, CARD),
    # What is counted stays, whatever is beneath it; of two hidden things the upper one is shown.
    "count": (TOP,),
    "size": (TOP, CARD),
    "compare": (TOP, CARD),
}
pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def renderer():
    with Renderer() as it:
        yield it


@pytest.mark.parametrize("answer", ["B", "E"])
@pytest.mark.parametrize("question_type", TASKS)
def test_the_evidence_is_clear_and_nothing_has_moved(renderer, question_type, answer):
    task = replace(TASKS[question_type], scene=SCENE, answer=answer)
    view = oracle_view(task, LIBRARY, renderer)
    assert len(view.frames) == 2 and view.removed == REMOVED[question_type]
    shown = measure(renderer, SCENE.without(*view.removed))
    assert min(shown[number].fraction for number in task.targets) >= 0.5
    first, revealed = (frame.labels for frame in view.frames)
    assert first is not None and revealed is not None
    gone = np.isin(first, view.removed)
    assert (first[~gone] == revealed[~gone]).all() and not np.isin(revealed, view.removed).any()


def test_marks_are_on_the_first_picture_alone(renderer):
    task = replace(TASKS["size"], scene=SCENE)
    view = oracle_view(task, LIBRARY, renderer)
    plain = photograph(renderer, SCENE).rgb
    assert plain is not None and view.first.rgb is not None
    changed = (plain != view.first.rgb).any(axis=2)
    for mark in MARKS:
        assert changed[mark.point[::-1]]
    assert 0 < changed.sum() < 4000
    bare = photograph(renderer, SCENE.without(*view.removed)).rgb
    assert (bare == view.revealed.rgb).all()
