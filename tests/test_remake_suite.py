"""scripts/remake_suite.py: what stays, what is made anew and from where."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
import remake_suite as remake

from probe.api.resources import everything
from probe.errors import BadData
from probe.generation.attempt import Attempt
from probe.generation.build_folder import IMMOVABLE, KEPT, BuildFolder
from probe.generation.plan import ATTEMPTS
from probe.tasks.suite_file import demo_suite, find_suite, read_suite


def test_a_task_that_passes_is_kept_and_another_s_place_goes_on_after_it(tmp_path: Path):
    library = everything()
    parts = BuildFolder(tmp_path / "x.parts")
    good, stuck = demo_suite().tasks[:2]
    remake.settle(parts, good, "", library)
    remake.settle(parts, stuck, "mug went in 0 of 3 tries", library)
    for task, check in ((good, KEPT), (stuck, IMMOVABLE)):
        log = parts.log(Attempt.of_task(task).place)
        assert [line.seed for line in log][-1] == task.seed
        assert len(log) == task.seed % ATTEMPTS + 1
        assert log[-1].check == check
        assert {line.check for line in log[:-1]} <= {remake.EARLIER}
    place = Attempt.of_task(good).place
    assert read_suite(parts.task_path(place)).tasks == (good,)
    assert remake.unsettled(parts, demo_suite()) == list(demo_suite().tasks[2:])


def test_the_command_asks_for_the_same_places(tmp_path: Path):
    told = remake.rebuild_command(find_suite("v1"), tmp_path / "x.json", "procedural")
    assert "--public" in told and "--first 1000 " in told and "--counts.beneath 26" in told


def test_a_suite_with_gaps_is_refused(tmp_path: Path):
    v1 = find_suite("v1")
    gap = replace(v1, tasks=v1.tasks[1:])
    with pytest.raises(BadData, match="beneath"):
        remake.rebuild_command(gap, tmp_path / "x.json", "procedural")
