"""Three people's sessions over HTTP, from the door to one report that compares them."""

from __future__ import annotations

import json
import time
from collections.abc import Generator
from contextlib import contextmanager

import pytest

from interfaces.human.conftest import serving
from interfaces.human.painted_hall import Room
from interfaces.human.visitor import Visitor
from interfaces.painted import BLOCKS, SPECS
from pages import Page
from probe.cli.human import taken_up
from probe.cli.report import write_run_report
from probe.episodes.episode import Episode
from probe.episodes.files import read_records
from probe.episodes.folder import RECORDS
from probe.episodes.grading import answer_form, question_of
from probe.interfaces.human.session_manager import SessionManager
from probe.interfaces.human.table_places import TablePlace
from probe.perception.oracle import Oracle
from probe.runs.plan import RunOrder
from probe.tasks.suite import selection
from probe.toolshed.toolshed import Toolshed
from run_folders import DEMO, write_pictures, wrong_letter
from tabletops import Obedient, PaintedStation

TASKS = tuple(task for task in DEMO.tasks if task.question_type == "count")
SUITE = selection(DEMO, TASKS, "counts")
PAUSE = 1.5
"""Seconds for which Ada thinks over each answer."""

SESSIONS = {
    "Ada": ([task.answer for task in TASKS], PAUSE),
    "Bea": ([TASKS[0].answer, wrong_letter(TASKS[1])], 0.0),
    "Cleo": ([wrong_letter(task) for task in TASKS], 0.0),
}


class _AsLaid:
    """A painted table's poses, for the record: those of its task, since nothing is moved."""

    def __init__(self, task, station):
        self.task, self.joints = task, station.joints

    def snapshot(self):
        return self.task.scene


class CountingRoom(Room):
    """Painted tables under the demo's questions."""

    @contextmanager
    def furnish(self) -> Generator[TablePlace]:
        yield TablePlace(self.set_table, self.explain)

    def set_table(self, task, name, run):
        station = PaintedStation(BLOCKS)
        tools = Toolshed(station, Oracle(SPECS), Obedient(), task.setup, form=answer_form(task))
        question = question_of(task, tools.first_picture())
        return Episode(
            task.id, question, tools, _AsLaid(task, station), agent_name=name, run=run,
            viewpoint=task.viewpoint,
        )  # fmt: skip


@pytest.fixture
def folder(tmp_path):
    """A folder of three people's sessions, one after the other."""
    with taken_up(tmp_path, SUITE, RunOrder("")):
        hall = SessionManager(SUITE, tmp_path, CountingRoom().furnish, 2)
        with serving(hall) as port:
            for name, (letters, pause) in SESSIONS.items():
                _sit(Visitor(port, name), letters, pause)
    write_pictures(tmp_path, read_records(tmp_path / RECORDS), SUITE)
    return tmp_path


def _sit(visitor, letters, pause):
    assert visitor.enter()["total"] == len(letters)
    for letter in letters:
        visitor.call("perceive_scene")
        time.sleep(pause)
        assert visitor.call("answer_question", choice=letter)["over"]
        visitor.post("next")
        visitor.state()


def test_a_report_compares_what_they_got_right_and_how_long_they_took(folder):
    page = Page(write_run_report([folder]).read_text())
    (index,) = page.all("script", id="index-data")
    assert json.loads(index.text)["entrants"] == [f"{name} (human)" for name in SESSIONS]
    lines = (folder / "rows.jsonl").read_text().splitlines()
    rows = sorted((json.loads(line) for line in lines), key=lambda row: row["agent"])
    assert [row["agent"] for row in rows] == [name for name in SESSIONS for _ in TASKS]
    right = {name: [r["correct"] for r in rows if r["agent"] == name] for name in SESSIONS}
    assert {name: sum(each) for name, each in right.items()} == {"Ada": 2, "Bea": 1, "Cleo": 0}
    records = {(it.agent, it.task): it.seconds for it in read_records(folder / RECORDS)}
    for row in rows:
        taken = records[row["agent"], row["task"]]
        assert row["seconds_agent"] == pytest.approx(sum(taken.agent), abs=1e-3)
        assert row["seconds_tools"] == pytest.approx(sum(taken.tools), abs=1e-3)
        assert row["agent"] != "Ada" or row["seconds_agent"] >= PAUSE
