"""Examples and selections that tests make by hand."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from lessons import lesson, training_task
from probe.assets.spec import ObjectSpec
from probe.train.choose.chosen import LoadedSelection, read_selection, write_selection
from probe.train.choose.evaluation import evaluation_of
from probe.train.choose.selection import Recipe, select
from probe.train.dataset.examples import TrainingExample, example_of
from probe.train.dataset.showing import EpisodePictures
from probe.transcripts.pictures import jpeg
from tabletops import paint

LESSONS = [
    lesson(training_task(1), statuses=[("mug", "done"), ("box", "failed")]),
    lesson(training_task(2), setting="direct"),
    lesson(training_task(3, "count")),
]


def picture(shade: int) -> bytes:
    rgb = paint([]).rgb
    assert rgb is not None
    return jpeg(rgb[:64, :64] * 0 + shade)


def shown_in(it) -> EpisodePictures:
    """A first picture and one with each result but the last, all of them different."""
    later = [picture(10 * n) for n, _ in enumerate(it.record.steps[:-1], start=1)]
    return EpisodePictures((picture(250),), (*later, None) if it.record.steps else ())


@pytest.fixture
def examples() -> list[TrainingExample]:
    return [example_of(it.task, it.record, shown_in(it)) for it in LESSONS]


@pytest.fixture
def selection(tmp_path) -> Callable[[], Path]:
    """A function that writes the lessons as a selection."""

    def write() -> Path:
        recipe = Recipe(slack=1)
        found = select(LESSONS, evaluation_of([]), recipe)
        objects = {o.object_id: (1.0, 2.0) for it in LESSONS for o in it.task.scene.objects}
        write_selection(tmp_path / "selected", found, recipe, objects, [Path("c1")], ["v1"])
        return tmp_path / "selected"

    return write


@pytest.fixture
def chosen(selection) -> LoadedSelection:
    return read_selection(selection())


@pytest.fixture
def specs(chosen) -> dict[str, ObjectSpec]:
    """Of the objects that are shown: one of them is somebody else's."""
    ids = sorted({it.object_id for task in chosen.suite.tasks for it in task.scene.objects})
    return {
        id: ObjectSpec(
            id, "mug", "mug", ("red",), "A mug.", 0.1, 0.5, (0.1, 0.1, 0.1), False,
            "procedural", "CC-BY-4.0" if n == 0 else "CC0-1.0", "somebody" if n == 0 else "PROBE",
        )
        for n, id in enumerate(ids)
    }  # fmt: skip
