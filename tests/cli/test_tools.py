"""`probe tools bench` from outside: a few real attempts, interrupted and gone on with."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

from probe.tool_bench.work import read_trials

pytestmark = pytest.mark.slow


@pytest.fixture
def bench(tmp_path):
    environment = dict(os.environ)
    environment.pop("PROBE_ASSETS", None)

    def run(*arguments: object) -> subprocess.CompletedProcess[str]:
        told = ["-m", "probe", "tools", "bench", "--out", tmp_path / "out", *arguments]
        return subprocess.run(
            [sys.executable, *map(str, told)],
            env=environment,
            capture_output=True,
            text=True,
            check=False,
        )

    return run


def test_it_counts_reports_and_goes_on(bench, tmp_path):
    out = tmp_path / "out"
    done = bench("--grasps", 2, "--pushes", 1)
    assert done.returncode == 0, done.stderr
    first = read_trials(out)
    assert [trial.tool for trial in first] == ["grasp", "grasp", "push"]
    assert "of 2" in done.stdout and (out / "index.html").exists()
    done = bench("--grasps", 7, "--pushes", 1)
    assert done.returncode == 0, done.stderr
    later = read_trials(out)
    assert [t.tool for t in later].count("grasp") == 7 and later[:2] == first[:2]
    page = (out / "index.html").read_text()
    failures = [trial for trial in later if not trial.good]
    assert page.count("<figure>") == len(failures) == len(list((out / "pictures").glob("*.jpg")))


def test_other_settings_and_broken_lines_are_refused(bench, tmp_path):
    assert bench("--grasps", 1, "--pushes", 0).returncode == 0
    refused = bench("--grasps", 1, "--pushes", 0, "--sigma", 0.01)
    assert refused.returncode == 1 and "was begun with grasp_noise 0.0, not 0.01" in refused.stderr
    (file,) = (tmp_path / "out").glob("trials-*.jsonl")
    file.write_bytes(file.read_bytes()[:-20] + b"\n")
    refused = bench("--grasps", 2, "--pushes", 0)
    assert refused.returncode == 1 and f"{file.name}:1" in refused.stderr
    assert bench("--shard", "2/2").returncode == 1
