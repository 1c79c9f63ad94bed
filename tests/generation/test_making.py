"""Tasks made by an engine, by workers that see the folder and by others."""

from __future__ import annotations

from pathlib import Path

import pytest

from probe.api.resources import opener, tables_for
from probe.engines.local import LocalEngine
from probe.errors import ProbeError
from probe.generation.build_folder import BuildFolder, TaskSlot
from probe.generation.making import TaskMaker, make_tasks

PLACES = [TaskSlot("count", 0), TaskSlot("count", 1)]


def made(folder: Path, *, seen: bool) -> BuildFolder:
    parts = BuildFolder(folder)
    maker = TaskMaker(parts if seen else None, opener("procedural"), tables_for("procedural"))
    results = dict(make_tasks(maker, parts, PLACES, LocalEngine(2)))
    assert results == dict.fromkeys(PLACES)
    return parts


@pytest.mark.slow
def test_workers_that_do_not_see_the_folder_make_the_same_tasks(tmp_path):
    here, sent = made(tmp_path / "here", seen=True), made(tmp_path / "sent", seen=False)
    assert {file.name for file in here.folder.iterdir()} == {f.name for f in sent.folder.iterdir()}
    for place in PLACES:
        assert here.task_path(place).read_bytes() == sent.task_path(place).read_bytes()
        one, other = here.log(place), sent.log(place)
        assert [(it.seed, it.check) for it in one] == [(it.seed, it.check) for it in other]


@pytest.mark.slow
def test_a_log_that_cannot_be_read_ends_the_work_and_is_named(tmp_path):
    parts = BuildFolder(tmp_path)
    parts.log_path(PLACES[0]).write_text("nonsense\n")
    maker = TaskMaker(parts, opener("procedural"), tables_for("procedural"))
    with pytest.raises(ProbeError, match=r"count-0\.tsv"):
        list(make_tasks(maker, parts, PLACES, LocalEngine(1)))
