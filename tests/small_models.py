"""A data set of episodes made by hand, and a very small model for it."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from lessons import lesson, training_task
from probe.assets.spec import ObjectSpec
from probe.toolshed.result import Status
from probe.train.choose.chosen import read_selection, write_selection
from probe.train.choose.evaluation import evaluation_of
from probe.train.choose.selection import Recipe, select
from probe.train.dataset.examples import example_of
from probe.train.dataset.folder import Form, write_dataset
from probe.train.dataset.showing import EpisodePictures
from probe.train.dataset.text_only import as_text_only, no_pictures
from probe.train.tune.tiny import make_tiny
from probe.train.tune.tiny_parts import Shape
from probe.transcripts.pictures import jpeg
from tabletops import paint

GRASPED: tuple[str, Status] = ("mug", "done")
SHAPE = Shape(
    width=48, layers=2, words=600, vision_width=32, vision_layers=2, side_px=64, seed=3
)  # fmt: skip


def small_dataset(folder: Path, tasks: int = 4, *, pictures: bool = True) -> Path:
    """Some episodes of Find and Count with tools, and one without if there are pictures."""
    lessons = [
        lesson(training_task(n, question_type), statuses=(GRASPED,) * (1 + n % 2))
        for n in range(1, tasks + 1)
        for question_type in ("find", "count")
    ]
    if pictures:
        lessons.append(lesson(training_task(50), setting="direct"))
    recipe = Recipe(slack=3, direct_share=1.0)
    found = select(lessons, evaluation_of([]), recipe)
    objects = {it.object_id: (1.0, 2.0) for each in lessons for it in each.task.scene.objects}
    write_selection(folder / "selected", found, recipe, objects, [Path("c1")], ["v1"])
    chosen = read_selection(folder / "selected")
    if not pictures:
        chosen = as_text_only(chosen, "short")
    examples = [
        example_of(task, record, _shown(len(record.steps)) if pictures else no_pictures(record))
        for task, record in chosen.episodes
    ]
    specs = {id: _spec(id) for id in objects}
    write_dataset(folder / "data", examples, chosen, Form("small", "pixels", 64, False), specs)
    return folder / "data"


def small_model(folder: Path, dataset: Path, *, pictures: bool = True) -> Path:
    make_tiny(dataset, folder / "tiny", replace(SHAPE, pictures=pictures))
    return folder / "tiny"


def _shown(steps: int) -> EpisodePictures:
    later = [picture(10 * n) for n in range(1, steps)]
    return EpisodePictures((picture(250),), (*later, None) if steps else ())


def picture(shade: int) -> bytes:
    rgb = paint([]).rgb
    assert rgb is not None
    return jpeg(rgb[:64, :64] * 0 + shade)


def _spec(id: str) -> ObjectSpec:
    return ObjectSpec(
        id, "mug", "mug", ("red",), "A mug.", 0.1, 0.5, (0.1, 0.1, 0.1), False,
        "procedural", "CC0-1.0", "PROBE",
    )  # fmt: skip
