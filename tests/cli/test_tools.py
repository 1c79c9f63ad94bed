"""`probe tools bench` from outside: a few real attempts, interrupted and gone on with."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from probe.cli import main
from probe.tool_bench.work import read_trials

pytestmark = pytest.mark.slow


def words(out: Path, *arguments: object) -> list[str]:
    return ["tools", "bench", "--out", str(out), *map(str, arguments)]


def bench(out: Path, *arguments: object) -> str:
    """Run it to its good end; gives what it said."""
    done = subprocess.run(
        [sys.executable, "-m", "probe", *words(out, *arguments)],
        env={name: value for name, value in os.environ.items() if name != "PROBE_ASSETS"},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def begun(tmp_path_factory) -> tuple[Path, str]:
    """A folder with a few attempts, and what was said of them."""
    out = tmp_path_factory.mktemp("tools") / "out"
    return out, bench(out, "--grasps", 2, "--pushes", 1)


@pytest.fixture
def out(begun, tmp_path) -> Path:
    """A copy of that folder."""
    return shutil.copytree(begun[0], tmp_path / "out")


@pytest.fixture
def refused(monkeypatch) -> Callable[..., str]:
    """Says why it ends at once; that is known in this process as well."""
    monkeypatch.delenv("PROBE_ASSETS", raising=False)

    def run(out: Path, *arguments: object) -> str:
        monkeypatch.setattr(sys, "argv", ["probe", *words(out, *arguments)])
        with pytest.raises(SystemExit) as ending:
            main()
        # Python prints a text that a program ends with, and ends with status 1.
        assert isinstance(ending.value.code, str)
        return ending.value.code

    return run


def test_it_counts_reports_and_goes_on(begun, out):
    first = read_trials(out)
    assert [trial.tool for trial in first] == ["grasp", "grasp", "push"]
    assert "of 2" in begun[1] and (out / "index.html").exists()
    bench(out, "--grasps", 7, "--pushes", 1)
    later = read_trials(out)
    assert [t.tool for t in later].count("grasp") == 7 and later[:2] == first[:2]
    page = (out / "index.html").read_text()
    failures = [trial for trial in later if not trial.good]
    assert page.count("<figure>") == len(failures) == len(list((out / "pictures").glob("*.jpg")))


def test_other_settings_and_broken_lines_are_refused(out, refused):
    told = refused(out, "--grasps", 1, "--pushes", 0, "--sigma", 0.01)
    assert "was begun with grasp_noise 0.0, not 0.01" in told
    (file,) = out.glob("trials-*.jsonl")
    broken, rest = file.read_bytes().split(b"\n", 1)
    file.write_bytes(broken[:-20] + b"\n" + rest)
    assert f"{file.name}:1" in refused(out, "--grasps", 3, "--pushes", 0)
    assert "2/2" in refused(out, "--shard", "2/2")
