"""`benchmarks/internals/bridge_cuts.py`, done small: what moves stops, and nothing is scored."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

SCRIPT = Path(__file__).resolve().parents[2] / "benchmarks" / "internals" / "bridge_cuts.py"


@pytest.mark.slow
def test_a_harmed_link_stops_the_arm_and_the_session_goes_on() -> None:
    harm = "cable pulled"
    ended = subprocess.run(
        [sys.executable, str(SCRIPT), "--tries", "1", "--only", harm],
        capture_output=True,
        text=True,
    )
    assert ended.returncode == 0, ended.stdout + ended.stderr
    (row,) = (line for line in ended.stdout.splitlines() if line.startswith(f"\u2502 {harm}"))
    assert row.split("\u2502")[-2].strip() == "1"
