"""`probe robustness` on records that are made by hand; nothing is drawn."""

import json
from dataclasses import replace
from importlib import import_module
from pathlib import Path

import pytest

from probe.api.progress import Track
from probe.cli.robustness import robustness
from probe.episodes.conditions import Conditions
from probe.episodes.folder import SUITE
from probe.episodes.grading import question_of
from probe.episodes.ordered import note_ordered
from probe.episodes.record import EpisodeRecord, TableState
from probe.errors import BadData
from probe.runs.variation import VARIATION
from probe.tasks.grading import Score
from probe.tasks.suite_file import demo_suite, write_suite
from probe.tasks.task import Task
from probe.toolshed.result import Answer

DEMO = demo_suite()
TILTED = Conditions(camera="tilted")


def episodes(conditions: Conditions, wrong: int) -> list[EpisodeRecord]:
    """A record of each demo task, of which the first few are answered wrongly."""
    made = [
        EpisodeRecord(
            task.id,
            "scripted",
            0,
            question_of(task),
            TableState(task.scene, (0.0,) * 6),
            (),
            Answer("A" if number >= wrong else "B"),
            "answered",
        )
        for number, task in enumerate(DEMO.tasks)
    ]
    return [replace(record, conditions=conditions) for record in made]


@pytest.fixture
def folders(tmp_path, monkeypatch):
    """A plain run that is always right, and one with a tilted camera; "A" stands for right."""
    records = {"plain": episodes(Conditions(), 0), "tilted": episodes(TILTED, 2)}
    for name in records:
        write_suite(tmp_path / name / SUITE, DEMO)
    note = {"base": "x", "conditions": TILTED.label, "notes": {DEMO.tasks[0].id: "it shows"}}
    (tmp_path / "tilted" / VARIATION).write_text(json.dumps(note))

    def graded(out: Path, track: Track):
        return [
            graded_one(task, record)
            for task, record in zip(DEMO.tasks, records[out.name], strict=True)
        ]

    def graded_one(task: Task, record: EpisodeRecord):
        right = record.answer is not None and record.answer.choice == "A"
        said = Answer(task.answer if right else "A" if task.answer != "A" else "B")
        return (
            task,
            replace(record, answer=said),
            Score(right, right, "right" if right else "wrong"),
        )

    monkeypatch.setattr(import_module("probe.cli.robustness"), "graded", graded)
    return tmp_path / "plain", tmp_path / "tilted"


def test_a_run_is_compared_with_the_plain_one(folders, tmp_path, capsys):
    plain, tilted = folders
    robustness(plain, (tilted,), out=tmp_path / "out.json")
    (shift,) = json.loads((tmp_path / "out.json").read_text())
    # Both tasks of one of three types went wrong.
    assert shift["pair"]["difference"] == pytest.approx(-1 / 3)
    assert (shift["plain"], shift["other"]) == (1.0, pytest.approx(2 / 3))
    assert (shift["certified_tasks"], shift["pair"]["first"][1]) == (5, "scripted, camera tilted")
    shown = " ".join(capsys.readouterr().out.split())
    assert "n = 6 tasks, of which 5 still are what was certified" in shown


def test_the_plain_run_comes_first(folders, tmp_path):
    plain, tilted = folders
    with pytest.raises(BadData, match="camera tilted.*Name a plain run first"):
        robustness(tilted, (plain,), out=tmp_path / "out.json")
    with pytest.raises(BadData, match="no other conditions"):
        robustness(plain, (plain,), out=tmp_path / "out.json")
    assert not (tmp_path / "out.json").exists()


def test_what_was_ordered_and_is_not_there_is_missing(folders, tmp_path, capsys):
    plain, tilted = folders
    note_ordered(tilted, "scripted", "", runs=2)
    robustness(plain, (tilted,), out=tmp_path / "out.json")
    (shift,) = json.loads((tmp_path / "out.json").read_text())
    assert shift["missing"] == len(DEMO.tasks)
    assert "6" in capsys.readouterr().out


def test_other_tools_are_told_of(folders, tmp_path, capsys, monkeypatch):
    plain, tilted = folders
    graded = import_module("probe.cli.robustness").graded

    def earlier(out: Path, track: Track):
        version = {"plain": 1, "tilted": 2}[out.name]
        return [(task, replace(it, tools=version), score) for task, it, score in graded(out, track)]

    monkeypatch.setattr(import_module("probe.cli.robustness"), "graded", earlier)
    robustness(plain, (tilted,), out=tmp_path / "out.json")
    (shift,) = json.loads((tmp_path / "out.json").read_text())
    assert shift["tools"] == [1, 2]
    assert "versions of the tools (1 and 2)" in " ".join(capsys.readouterr().out.split())
