"""Each command, given something else than the file that it wants, says so in one line and ends."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from run_folders import DEMO, episode, write_run

pytestmark = pytest.mark.slow

PATIENCE = 120.0
MODEL = ("run", "demo", "--model", "x", "--endpoint", "http://127.0.0.1:9/v1", "--dry-run")
COMMANDS = {
    "show": ("suite", "show", "BAD"),
    "verify": ("suite", "verify", "BAD", "--out", "new"),
    "run": ("run", "BAD", "--out", "new"),
    "prices": (*MODEL, "--prices", "BAD"),
    "rescore": ("rescore", "BAD"),
    "build log": ("report", "good", "--build-log", "BAD"),
    "robustness": ("robustness", "good", "BAD", "--out", "new"),
    "merge": ("merge", "good", "BAD", "--out", "new"),
    "learnt": ("held-out", "good", "--learnt", "BAD", "--out", "new"),
    "select": ("select", "BAD", "--out", "new", "--no-near"),
    "dataset": ("dataset", "BAD", "new"),
    "obj": ("assets", "add", "obj", "BAD"),
    "collect": ("collect", "--split", "BAD", "--out", "new", "--counts.count", "1"),
    "serve": ("serve", "--suite", "BAD", "--out", "new"),
}
QUESTION_TYPES = ("missing", "empty", "cut", "noise", "deep", "folder", "pipe", "/dev/zero")


@pytest.fixture(scope="module")
def place(tmp_path_factory) -> Path:
    folder = tmp_path_factory.mktemp("bad")
    write_run(
        folder / "good", [episode(task) for task in DEMO.tasks if task.question_type != "find"]
    )
    (folder / "empty").touch()
    (folder / "cut").write_bytes((folder / "good" / "suite.json").read_bytes()[:5000])
    (folder / "noise").write_bytes(bytes(range(256)) * 10)
    (folder / "deep").write_text("[" * 200_000)
    (folder / "folder").mkdir()
    os.mkfifo(folder / "pipe")
    return folder


@pytest.mark.parametrize("command", COMMANDS)
def test_what_is_no_such_file_is_refused(place, command):
    told = os.environ | {"PROBE_LIBRARY": str(place / "library")}
    told.pop("PROBE_ASSETS", None)
    for question_type in QUESTION_TYPES:
        bad = question_type if question_type.startswith("/") else str(place / question_type)
        words = [bad if word == "BAD" else word for word in COMMANDS[command]]
        ended = subprocess.run(
            [sys.executable, "-m", "probe", *words],
            capture_output=True, text=True, timeout=PATIENCE, cwd=place, env=told,
            stdin=subprocess.DEVNULL,
        )  # fmt: skip
        said = ended.stdout + ended.stderr
        assert "Traceback" not in said, (question_type, said)
        # An OBJ that can't be used is a line of the table, among those that can.
        assert ended.returncode == 1 or command == "obj", (question_type, said)
        assert not (place / "new").exists(), question_type
