"""Names from files and models can't steer a terminal, crash a table, or become formulas."""

from __future__ import annotations

import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import pytest

from probe.cli.screen import ScreenTable, bar, say, say_above, track
from probe.episodes.record import EpisodeRecord
from probe.generation.build_folder import CandidateLog
from probe.scores.row_files import read_csv, write_csv
from probe.tasks.suite import Suite
from probe.tasks.task import Option, Task
from run_folders import DEMO, episode, write_run
from score_rows import row

HOSTILE = "=x\x1b]0;pwned\x07\x1b[2J\x9b31m\u202e[/red][bold\nprobe: all is well\r\x08"
SHOWN = r"=x\x1b]0;pwned\x07\x1b[2J\x9b31m\u202e[/red][bold"
SUITE = Suite(
    f"small {HOSTILE}",
    tuple(
        replace(
            task,
            question=f"{task.question} {HOSTILE}",
            options=tuple(Option(it.letter, f"{it.text} {HOSTILE}") for it in task.options),
        )
        for task in DEMO.tasks
        if task.question_type != "find"
    ),
    DEMO.objects,
)


def harmless(output: bytes) -> bool:
    text = output.decode()
    odd = {sign for sign in text if sign < " " or "\x7f" <= sign <= "\x9f" or sign == "\u202e"}
    return odd <= {"\n"}


def probe(*words: object, cwd: Path) -> subprocess.CompletedProcess[bytes]:
    return subprocess.run(
        [sys.executable, "-m", "probe", *map(str, words)],
        capture_output=True,
        timeout=300,
        cwd=cwd,
        env=os.environ | {"COLUMNS": "400"},
    )


def hostile(task: Task, fault: str | None = None) -> EpisodeRecord:
    """An episode in which everything that can be said is; no tool takes such an id."""
    record = episode(task, agent=HOSTILE, words=HOSTILE, fault=fault)
    looked, grasped, *rest = record.steps
    return replace(record, steps=(looked, replace(grasped, status="malformed"), *rest))


@pytest.fixture(scope="module")
def folder(tmp_path_factory) -> Path:
    records = [
        hostile(SUITE.tasks[0]),
        hostile(SUITE.tasks[1], fault=HOSTILE),
    ]
    return write_run(tmp_path_factory.mktemp("runs") / "hostile", records, SUITE)


@pytest.mark.parametrize(
    ("command", "status"),
    [
        (("suite", "show", "suite.json"), 0),
        (("rescore", "."), 0),
        (("report", "."), 0),
        (("run", "suite.json", "--model", "x", "--endpoint", "http://[::1]:9", "--dry-run"), 0),
        (("run", "suite.json", "--agent", "random", "--noise", "paper", "--out", "."), 1),
        (("merge", ".", ".", "--out", "../merged"), 1),
        (("serve", "--suite", "suite.json", "--task", HOSTILE), 1),
    ],
)
def test_no_command_lets_escape_sequences_through(folder, command, status):
    ended = probe(*command, cwd=folder)
    assert ended.returncode == status, ended.stderr.decode()
    assert b"Traceback" not in ended.stderr
    assert harmless(ended.stdout + ended.stderr)
    if command[:2] == ("suite", "show"):
        assert SHOWN in ended.stdout.decode()


def test_tables_lines_and_bars_show_what_stands_there(capsysbinary, monkeypatch):
    monkeypatch.setenv("COLUMNS", "400")
    table = ScreenTable("a", "b", title=HOSTILE)
    table.add(HOSTILE, f"two\nlines {HOSTILE}")
    table.show()
    say(HOSTILE, 3)
    with bar() as progress:
        task = progress.add_task(HOSTILE, total=1)
        say_above(progress, HOSTILE)
        progress.advance(task)
    assert list(track([1, 2], HOSTILE)) == [1, 2]
    output = capsysbinary.readouterr().out
    assert harmless(output)
    assert output.decode().count(SHOWN) >= 6


def test_rows_hold_no_formula_and_come_back(tmp_path):
    rows = [row("t", agent=text) for text in (HOSTILE, "=HYPERLINK(1)", "'=1", "-5", "@a", "b")]
    write_csv(tmp_path / "rows.csv", rows)
    text = (tmp_path / "rows.csv").read_text()
    assert "'=HYPERLINK(1)" in text and ",=" not in text and ",@" not in text
    assert read_csv(tmp_path / "rows.csv") == rows


def test_a_line_of_a_log_comes_back():
    line = CandidateLog("find", 3, "kept", None, "=1+1", 2.0)
    assert str(line).split("\t")[4] == "'=1+1"
    assert CandidateLog.parse(str(line)) == line
