"""`benchmarks/internals/worlds.py` on two tasks: each of the answers is true of its own table."""

from __future__ import annotations

import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from probe.assets.library import open_library
from probe.render.renderer import Renderer
from probe.tasks.suite import selection
from probe.tasks.suite_file import packaged_suite, read_suite, write_suite
from probe.tasks.task import LETTERS
from probe.verification.remeasure import Remeasurement
from probe.verification.truth import truth_problems

SCRIPT = Path(__file__).resolve().parents[2] / "benchmarks/internals/worlds.py"


@pytest.mark.slow
def test_each_letter_is_right_of_one_of_the_worlds(tmp_path: Path, cache: Path):
    """Ranked has three targets of which other things decide; Memory keeps two bystanders."""
    library = open_library("evaluation", None, cache)
    every = packaged_suite("v2")
    some = [next(it for it in every if it.question_type == kind) for kind in ("memory", "ranked")]
    write_suite(tmp_path / "two.json", selection(every, tuple(some), "two"))
    out = tmp_path / "worlds.json"
    ended = subprocess.run(
        [sys.executable, str(SCRIPT), str(tmp_path / "two.json"), str(out)],
        capture_output=True,
        text=True,
    )
    assert ended.returncode == 0, ended.stdout + ended.stderr
    # Whoever always says one letter is right in one of a task's five scenes.
    assert out.with_suffix(".md").read_text().count("| always A | 20.0% | 5 |") == 2
    worlds = read_suite(out).tasks
    for task in some:
        mine = [it for it in worlds if it.id.startswith(task.id)]
        assert sorted(it.answer for it in mine) == [*LETTERS]
        assert task.scene in [it.scene for it in mine if it.answer == task.answer]
    with Renderer() as renderer:
        for world in worlds:
            anew = Remeasurement(world.scene, library, renderer, world.camera)
            assert not list(truth_problems(world, anew))
            other = next(letter for letter in LETTERS if letter != world.answer)
            assert list(truth_problems(replace(world, answer=other), anew))
