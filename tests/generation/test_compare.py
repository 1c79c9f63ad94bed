"""What shows of a Compare task can't tell, or it alone tells: its opposite has the same scene."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest

from probe.assets.library import Library
from probe.assets.tables import load_table
from probe.generation.in_view import OPEN_QUARTER
from probe.generation.plan import plan, plan_of
from probe.generation.result import Rejected
from probe.generation.task_plan import CROSSED, TaskPlan
from probe.question_types.compare.generator import generate_compare
from probe.render.photograph import load_scene, photograph
from probe.render.renderer import Renderer
from probe.tasks.task import Task

TABLES = ("oak_planks",)

SEEDS = 1000, 4000
"""The first gives a task, the other none."""


def opposite(one: TaskPlan) -> TaskPlan:
    """Of the same look under the same letters, answered by the other one."""
    _, tells, more = CROSSED.of(one)
    letter = "B" if one.letter == "A" else "A"
    return CROSSED.put(replace(one, letter=letter), (letter, not tells, not more))


def made(seed: int, wanted: TaskPlan, library: Library, renderer: Renderer) -> Task | str:
    try:
        return generate_compare(seed, wanted, library, renderer, TABLES).task
    except Rejected as failure:
        return failure.rejection.check


def picture(task: Task, library: Library, renderer: Renderer):
    load_scene(renderer, task.scene, library, load_table(TABLES[0], None))
    frame = photograph(renderer, task.scene)
    assert frame.rgb is not None
    return frame.rgb.astype(int)


@pytest.mark.slow
def test_the_opposite_plan_gives_the_same_picture_and_the_other_answer(
    library: Library, renderer: Renderer
):
    kept = 0
    for seed in SEEDS:
        wanted = OPEN_QUARTER.put(plan("compare", seed), value=False)
        one, other = (made(seed, each, library, renderer) for each in (wanted, opposite(wanted)))
        if isinstance(one, str) or isinstance(other, str):
            assert one == other
            continue
        kept += 1
        assert one.answer != other.answer and one.question == other.question
        assert one.certificate.candidates[:2] == other.certificate.candidates[2:]
        assert [o.pose for o in one.scene.objects] == [o.pose for o in other.scene.objects]
        apart = np.abs(picture(one, library, renderer) - picture(other, library, renderer)).max(
            axis=-1
        )
        marked = [mark.instance for mark in one.marks]
        assert marked == [mark.instance for mark in other.marks]
        # Grain differs, where something of the two shows; nothing else does.
        assert (apart > 40).sum() <= 20
        assert (apart > 0).mean() < 0.02
    assert kept


def openly_darker(library: Library, renderer: Renderer) -> Iterator[tuple[Task, Task]]:
    """Tasks whose marked things lie open, one of them darker, and their opposites."""
    for episode in range(3000, 3400):
        wanted = plan_of("compare", episode)
        if not OPEN_QUARTER.of(wanted) or wanted.form != "darker":
            continue
        plans = wanted, opposite(wanted)
        one, other = (made(episode * 1000, each, library, renderer) for each in plans)
        if isinstance(one, str) or isinstance(other, str):
            assert isinstance(one, str) and isinstance(other, str)
        else:
            yield one, other


@pytest.mark.slow
def test_where_both_lie_open_the_opposite_plan_changes_their_paint_alone_and_it_tells(
    library: Library, renderer: Renderer
):
    one, other = next(openly_darker(library, renderer))
    assert one.answer != other.answer and one.question == other.question
    assert one.certificate.candidates[:2] == other.certificate.candidates[2:]
    assert [o.pose for o in one.scene.objects] == [o.pose for o in other.scene.objects]
    assert [mark.point for mark in one.marks] == [mark.point for mark in other.marks]
    for task in (one, other):
        load_scene(renderer, task.scene, library, load_table(TABLES[0], None))
        frame = photograph(renderer, task.scene)
        assert frame.rgb is not None and frame.labels is not None
        brightness = {
            mark.letter: frame.rgb[frame.labels == mark.instance].mean() for mark in task.marks
        }
        assert min(brightness, key=brightness.__getitem__) == task.answer
