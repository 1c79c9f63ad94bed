"""runs/distill.sh from top to bottom, much smaller than it is."""

from __future__ import annotations

import os
import socket
import subprocess
import sys
from pathlib import Path

import pytest

from probe.tasks.suite import part
from probe.tasks.suite_file import demo_suite, write_suite

ROOT = Path(__file__).resolve().parents[1]
SMALL = {
    "ARMS": "direct",
    "COUNTS": "--counts.count 1 --counts.find 0 --counts.size 0 --counts.reduce 0 "
    "--counts.compare 0",
    "SELECT": "--slack 9 --no-near",
    "TINY": "--width 48 --layers 2 --words 600 --vision-width 32 --vision-layers 2 --side-px 64",
    "TRAIN": "--learning-rate 1e-3 --global-batch 1 --epochs 2",
}


@pytest.mark.slow
def test_the_recipe(tmp_path):
    demo = demo_suite()
    one = next(task for task in demo.tasks if task.kind == "count")
    write_suite(tmp_path / "one.json", part(demo, one))
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = str(free.getsockname()[1])
    settings = SMALL | {"SUITE": str(tmp_path / "one.json"), "OUT": str(tmp_path / "out")}
    settings |= {"PORT": port, "PROBE": f"{sys.executable} -m probe"}
    done = subprocess.run(
        [str(ROOT / "runs/distill.sh")],
        env={**os.environ, **settings},
        capture_output=True,
        text=True,
        timeout=900,
    )
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-4000:]
    table = (tmp_path / "out/table.md").read_text()
    rows = [line.split(" | ")[0].strip("| ") for line in table.splitlines() if line[:1] == "|"][2:]
    assert {"untrained, direct", "trained, direct", "scripted, scripted"} < set(rows)
    assert "question-only, blind" in rows and any(row.startswith("always-") for row in rows)
    assert (tmp_path / "out/trained/README.md").exists()
