"""Each command, given something else than the file that it wants, says so in one line and ends."""

from __future__ import annotations

import multiprocessing
import os
import signal
import sys
import threading
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path

import pytest

from probe.cli import main
from run_folders import DEMO, episode, write_run

pytestmark = pytest.mark.slow

PATIENCE = 120
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


@pytest.fixture
def ended(place, monkeypatch, capsys):
    """Runs a command in this process, to its end; gives its exit status and all that it said."""
    monkeypatch.chdir(place)
    monkeypatch.setenv("PROBE_LIBRARY", str(place / "library"))
    monkeypatch.delenv("PROBE_ASSETS", raising=False)

    def run(words: list[str]) -> tuple[object, str]:
        monkeypatch.setattr(sys, "argv", ["probe", *words])
        status = None
        with open(os.devnull) as nothing, patience():
            monkeypatch.setattr(sys, "stdin", nothing)
            try:
                main()
            except SystemExit as ending:
                status = ending.code
        out, err = capsys.readouterr()
        # Python prints a text that a program ends with, and ends with status 1.
        return (1, f"{out}{err}{status}") if isinstance(status, str) else (status or 0, out + err)

    return run


@contextmanager
def patience() -> Generator[None]:
    """Nothing may take longer, nor leave anything for which Python would wait before it ends."""

    def over(*_: object) -> None:
        pytest.fail(f"It is still at work after {PATIENCE} s.")

    before, usual = set(threading.enumerate()), signal.signal(signal.SIGALRM, over)
    signal.alarm(PATIENCE)
    try:
        yield
    finally:
        signal.alarm(0)
        signal.signal(signal.SIGALRM, usual)
    assert [it for it in threading.enumerate() if it not in before and not it.daemon] == []
    assert multiprocessing.active_children() == []


@pytest.mark.parametrize("command", COMMANDS)
def test_what_is_no_such_file_is_refused(place, ended, command):
    for question_type in QUESTION_TYPES:
        bad = question_type if question_type.startswith("/") else str(place / question_type)
        words = [bad if word == "BAD" else word for word in COMMANDS[command]]
        # An error of ours, which would be printed with its traceback, comes through here.
        status, said = ended(words)
        assert "Traceback" not in said, (question_type, said)
        # An OBJ that can't be used is a line of the table, among those that can.
        assert status == 1 or command == "obj", (question_type, said)
        assert not (place / "new").exists(), question_type
