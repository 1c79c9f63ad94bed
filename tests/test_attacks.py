"""`benchmarks/internals/attacks/run.py`, done small: nothing crashes, nothing is read wrongly."""

import subprocess
import sys
from pathlib import Path

import pytest

SCRIPT = Path(__file__).resolve().parents[1] / "benchmarks" / "internals" / "attacks" / "run.py"
GROUPS = (
    *("files", "meshes", "options", "memory", "records", "flips"),
    *("page", "line", "kills", "replies"),
)

TRIED = tuple(group for group in GROUPS if group != "kills")
"""tests/cli/test_run_interrupted.py kills a run and goes on with it, in less time."""


@pytest.mark.slow
def test_no_attack_gets_through():
    """Groups of one process: the run that they spoil is played once."""
    ended = subprocess.run(
        [sys.executable, str(SCRIPT), "--only", *TRIED, "--scale", "0.02"],
        capture_output=True,
        text=True,
    )
    assert ended.returncode == 0, ended.stdout + ended.stderr
    assert [line for line in ended.stdout.splitlines() if line.endswith(" ...")] == [
        f"{group} ..." for group in TRIED
    ]
    (head,) = (line for line in ended.stdout.splitlines() if "tried" in line)
    assert "crashed" in head and "read wrongly" in head


def test_every_group_is_known_here():
    listed = SCRIPT.read_text().partition("by default all: ")[2].partition(".")[0]
    assert sorted(GROUPS) == sorted(listed.replace(",", " ").split())
