"""`probe dataset`: whose objects are compared with those that the episodes were played with."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from lessons import BY_KIND, FIRST_SEED, lesson, training_task
from probe.assets.library import Library
from probe.cli.dataset import dataset
from probe.errors import BadData
from probe.tasks.task import Task
from probe.train.choose.chosen import write_selection
from probe.train.choose.evaluation import evaluation_of
from probe.train.choose.selection import Recipe, select
from probe.train.dataset.manifest import check_dataset

TASK = replace(BY_KIND["count"], id="count-00000001", seed=FIRST_SEED)
CHANGED = (1.0, 2.0)
"""A fingerprint that no object has."""


def selected(folder: Path, task: Task) -> Path:
    found = select([lesson(task)], evaluation_of([]), Recipe())
    objects = {it.object_id: CHANGED for it in task.scene.objects}
    write_selection(folder / "selected", found, Recipe(), objects, [], ["v1"])
    return folder / "selected"


def test_pictures_are_drawn_of_unchanged_objects_alone(tmp_path):
    with pytest.raises(BadData, match="has changed since"):
        dataset(selected(tmp_path, TASK), tmp_path / "data", side=64, pool="procedural")
    assert not (tmp_path / "data").exists()


def test_without_pictures_no_object_is_built(tmp_path, monkeypatch):
    monkeypatch.setattr(Library, "body", None)
    monkeypatch.setattr(Library, "form", None)
    out = tmp_path / "data"
    dataset(selected(tmp_path, TASK), out, setting="text-only", pool="procedural")
    assert (check_dataset(out).total, check_dataset(out).pictures) == (1, 0)


def test_without_pictures_objects_must_be_known(tmp_path):
    with pytest.raises(BadData, match="there is no thing_count_1_1 here"):
        unknown = training_task(1, "count")
        dataset(selected(tmp_path, unknown), tmp_path / "data", setting="text-only")


@pytest.mark.parametrize(("graphs", "way"), [(None, "sizes"), ("full", "fewer")])
def test_what_full_lists_would_no_longer_be_true_of_is_not_told_again(tmp_path, graphs, way):
    with pytest.raises(BadData, match=f"--augment {way}: what full lists tell.*--graphs short"):
        dataset(tmp_path, tmp_path / "out", setting="text-only", graphs=graphs, augment=[way])
