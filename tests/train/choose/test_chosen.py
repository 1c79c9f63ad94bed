from __future__ import annotations

import resource
from dataclasses import replace

import pytest

from lessons import lesson, training_task
from probe.errors import BadData, OutputFailed
from probe.train.choose.chosen import read_selection, write_selection
from probe.train.choose.evaluation import evaluation_of
from probe.train.choose.selection import Recipe, select
from train.conftest import LESSONS


def test_a_selection_comes_back(selection):
    chosen = read_selection(selection())
    assert sorted(map(repr, chosen.episodes)) == sorted(
        repr((it.task, it.record)) for it in LESSONS
    )
    assert chosen.document.examples == {
        "count": {"direct": 0, "agentic": 1}, "find": {"direct": 1, "agentic": 1}
    }  # fmt: skip
    assert chosen.document.suites == ("v1",)


@pytest.mark.parametrize("name", ["records.jsonl", "suite.json"])
def test_a_file_that_was_cut_off_is_named(selection, name):
    folder = selection()
    path = folder / name
    path.write_bytes(path.read_bytes()[:-100])
    with pytest.raises(BadData, match=rf"{name}: isn't what was selected.*probe select"):
        read_selection(folder)
    path.unlink()
    with pytest.raises(BadData, match=rf"{name}: No such file.*probe select"):
        read_selection(folder)


def test_half_a_selection_is_none(selection):
    folder = selection()
    (folder / "selection.json").unlink()
    with pytest.raises(BadData, match=r"selection.json: No such file.*Select again"):
        read_selection(folder)
    with pytest.raises(BadData, match=r"selected: is there already. Choose a new folder"):
        selection()


def test_a_selection_that_was_stopped_leaves_nothing(tmp_path):
    """The disk holds its suite, but not its records."""
    it = lesson(training_task(1), statuses=[("mug", "done")])
    first, *others = it.record.steps
    told = replace(first, text="name: mug\n" * 3000)
    it = replace(it, record=replace(it.record, steps=(told, *others)))
    recipe = Recipe()
    found = select([it], evaluation_of([]), recipe)
    objects = {placed.object_id: (1.0, 2.0) for placed in it.task.scene.objects}
    limits = resource.getrlimit(resource.RLIMIT_FSIZE)
    resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, limits[1]))
    try:
        with pytest.raises(OutputFailed, match=r"records.jsonl.*nothing half-written is left"):
            write_selection(tmp_path / "selected", found, recipe, objects, [], [])
    finally:
        resource.setrlimit(resource.RLIMIT_FSIZE, limits)
    assert list(tmp_path.iterdir()) == []
    write_selection(tmp_path / "selected", found, recipe, objects, [], [])
    assert len(read_selection(tmp_path / "selected").episodes) == 1
