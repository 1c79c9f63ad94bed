"""`benchmarks/internals/attacks/run.py`, done small: nothing crashes, nothing is read wrongly."""

import subprocess
import sys
from pathlib import Path

import pytest

SCRIPT = Path(__file__).resolve().parents[1] / "benchmarks" / "internals" / "attacks" / "run.py"
GROUPS = {
    "from outside": ("files", "options", "memory", "meshes", "flips", "page", "line", "replies"),
    "on runs": ("records", "kills"),
}


@pytest.mark.slow
@pytest.mark.parametrize("groups", GROUPS.values(), ids=GROUPS)
def test_no_attack_gets_through(groups):
    ended = subprocess.run(
        [sys.executable, str(SCRIPT), "--only", *groups, "--scale", "0.02"],
        capture_output=True,
        text=True,
    )
    assert ended.returncode == 0, ended.stdout + ended.stderr
    assert [line for line in ended.stdout.splitlines() if line.endswith(" ...")] == [
        f"{group} ..." for group in groups
    ]
    (head,) = (line for line in ended.stdout.splitlines() if "tried" in line)
    assert "crashed" in head and "read wrongly" in head


def test_every_group_is_tried_small():
    named = sorted(group for groups in GROUPS.values() for group in groups)
    listed = SCRIPT.read_text().partition("by default all: ")[2].partition(".")[0]
    assert named == sorted(listed.replace(",", " ").split())
