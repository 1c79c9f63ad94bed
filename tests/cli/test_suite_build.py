"""`probe suite build` from outside: what can't be made is told at once, with the reason."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys

import pytest

from deadly_work import DeadlyMaker, refuse
from probe.api import suites
from probe.cli import suite
from probe.errors import ProbeError, Unfinished
from probe.generation.build_folder import KEPT, REPEATED, BuildFolder, CandidateLog, TaskSlot
from probe.generation.repeats import roles_of
from probe.tasks.suite_file import read_suite

CRATE = {
    "version": 1,
    "id": "own_crate",
    "name": "green crate",
    "category": "crate",
    "colours": ["green"],
    "description": "A crate.",
    "mass": 0.2,
    "friction": 0.5,
    "size": [0.1, 0.1, 0.05],
    "hollow": False,
    "licence": "CC0-1.0",
    "source": "a test",
    "provenance": {"name": "human"},
    "format": "gltf",
    "file": "crate.glb",
    "content": "0123456789abcdef0123456789abcdef",
    "unit": 1.0,
    "turn_wxyz": [1, 0, 0, 0],
    "shift": [0, 0, 0],
}


def build(tmp_path, *arguments):
    home = tmp_path / "library" / "own_crate"
    home.mkdir(parents=True)
    (home / "entry.json").write_text(json.dumps(CRATE))
    environment = {**os.environ, "PROBE_LIBRARY": str(home.parent)}
    environment.pop("PROBE_ASSETS", None)
    told = [sys.executable, "-m", "probe", "suite", "build", tmp_path / "mine.json", *arguments]
    return subprocess.run(
        list(map(str, told)), env=environment, capture_output=True, text=True, check=False
    )


def test_a_library_that_allows_nothing_is_told_in_seconds_and_nothing_is_written(tmp_path):
    asked = ["--pool", "own", "--counts.beneath", 1, "--counts.compare", 1, "--counts.size", 2]
    result = build(tmp_path, *asked)
    assert result.returncode == 1 and "Traceback" not in result.stderr
    said = " ".join(result.stderr.split())
    assert "No task was made" in said and "2 size: candidates: things of 4 to 17 cm" in said
    assert "1 compare: paint twins: 0 pairs" in said
    assert not (tmp_path / "mine.json").exists()


def test_compare_is_left_out_where_ones_own_have_no_paint_twins(tmp_path):
    result = build(tmp_path, "--pool", "own+procedural", "--counts.compare", 1)
    assert result.returncode == 1
    assert "1 things of your own play the parts" in result.stdout
    assert "0 pairs of things of your own differ in paint alone" in " ".join(result.stderr.split())


@pytest.mark.slow
def test_a_place_over_which_workers_die_is_no_success(tmp_path, monkeypatch, capsys):
    monkeypatch.delenv("PROBE_ASSETS", raising=False)
    monkeypatch.setattr(suite, "TaskMaker", DeadlyMaker)
    with pytest.raises(Unfinished, match="1 of 1 tasks .* The same command tries them again"):
        suite.build(tmp_path / "mine.json", counts={"size": 1}, public=True)
    assert "3 times" in " ".join(capsys.readouterr().out.split())
    assert not (tmp_path / "mine.json").exists()


@pytest.mark.slow
def test_a_task_about_the_same_things_as_another_is_made_again(tmp_path, monkeypatch):
    monkeypatch.delenv("PROBE_ASSETS", raising=False)
    out, one = tmp_path / "mine.json", {"beneath": 1}
    asked = {"pool": "procedural", "public": True, "unchecked": True}
    suite.build(out, counts=one, **asked)
    parts = BuildFolder(out.with_suffix(".parts"))
    first, second = (TaskSlot("beneath", number) for number in range(2))
    twin = parts.task_path(first).read_text()
    parts.task_path(second).write_text(twin)
    seed = read_suite(parts.task_path(first)).tasks[0].seed
    parts.add(second, CandidateLog("beneath", seed, KEPT, None, "", 1.0))
    suite.build(out, counts={"beneath": 2}, **asked)
    checks = [line.check for line in parts.log(second)]
    assert checks[0] == REPEATED and checks[-1] == KEPT
    assert parts.task_path(first).read_text() == twin
    made, again = read_suite(out).tasks
    assert roles_of(made) != roles_of(again) and again.seed % 1000 > 0
    assert f"\t{REPEATED}\t" in out.with_suffix(".log.tsv").read_text()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("module", "build", "bare"),
    [
        (suite, suite.build, {"unchecked": True}),
        (suites, suites.build_suite, {"certified": False}),
    ],
    ids=["command", "library"],
)
def test_every_checked_task_is_measured_again_before_it_is_kept(
    module, build, bare, tmp_path, monkeypatch
):
    monkeypatch.delenv("PROBE_ASSETS", raising=False)
    monkeypatch.setattr(module, "what_is_wrong", refuse)
    out, asked = tmp_path / "mine.json", {"counts": {"count": 1}, "pool": "procedural"}
    with pytest.raises(ProbeError, match="count-.* was measured again"):
        build(out, **asked, public=True)
    assert not out.exists()
    shutil.rmtree(out.with_suffix(".parts"))
    build(out, **asked, public=True, **bare)
    assert len(read_suite(out)) == 1
