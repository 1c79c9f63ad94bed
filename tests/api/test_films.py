"""Films of a folder: which are made, which are kept, and what is refused."""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

import pytest

from probe.agents.scripted import Scripted
from probe.api.films import clipped, filmed, recorded
from probe.cli.report import write_run_report
from probe.episodes.files import write_records
from probe.episodes.play import play
from probe.episodes.turns import Call
from probe.errors import BadData, MissingExtra
from probe.film.cutting import FPS
from probe.film.footage import CantFilm
from probe.report.clips import clip_stem
from probe.scene.seeds import generator
from probe.tasks.suite_file import demo_suite, write_suite
from probe.toolshed.result import MOVING
from recordings import rows_of

SUITE = demo_suite()
CALLS = (Call.of("perceive_scene"), Call.of("answer_question", {"choice": "E"}))


class Fixed:
    """Looks and answers."""

    def act(self, question, history):
        return CALLS[len(history)] if len(history) < len(CALLS) else None


@pytest.fixture(scope="module")
def record(library, renderer):
    return play(SUITE.tasks[0], Fixed(), "fixed", library, renderer)


@pytest.fixture
def folder(record, tmp_path) -> Path:
    write_suite(tmp_path / "suite.json", SUITE)
    write_records(tmp_path / "records.jsonl", [record])
    return tmp_path


@pytest.mark.slow
def test_a_film_is_made_once_and_kept(folder):
    av = pytest.importorskip("av")
    (facts,) = filmed(folder)
    assert facts.path == folder / "films" / f"{SUITE.tasks[0].id}-fixed-0.mp4"
    with av.open(facts.path) as film:
        count = sum(1 for _ in film.decode(video=0))
    assert count == round(facts.seconds * FPS) > 4 * FPS
    # Nothing moved, so that one picture of the stage is all that was drawn.
    assert facts.drawn == 1
    before = facts.path.stat().st_mtime_ns
    (kept,) = filmed(folder)
    assert (kept.path, kept.drawn) == (facts.path, 0)
    assert facts.path.stat().st_mtime_ns == before


@pytest.mark.slow
def test_a_grasp_is_a_clip_that_the_report_shows(library, renderer, tmp_path):
    pytest.importorskip("av")
    task = SUITE.tasks[0]
    agent = Scripted(task.question_type, task.subject, generator(task.seed, "run"), form=task.form)
    record = play(task, agent, "scripted", library, renderer)
    write_suite(tmp_path / "suite.json", SUITE)
    write_records(tmp_path / "records.jsonl", [record])
    moved = [n for n, step in enumerate(record.steps, 1) if step.call.name in MOVING]
    ((of, made),) = clipped(tmp_path)
    names = {f"{clip_stem(record, number)}.webm" for number in moved}
    assert of.task == task.id and made == len(moved) > 0
    assert {path.name for path in (tmp_path / "clips").iterdir()} == names
    assert all(path.stat().st_size < 150_000 for path in (tmp_path / "clips").iterdir())
    assert [count for _, count in clipped(tmp_path)] == [0]
    page = write_run_report([tmp_path], tmp_path / "page").read_text()
    assert all(f"clips/{name}" in page for name in names)
    assert {path.name for path in (tmp_path / "page" / "clips").iterdir()} == names


@pytest.mark.slow
def test_a_recording_is_made_once_and_kept(folder):
    pytest.importorskip("rerun")
    ((path, made),) = recorded(folder)
    assert made and path == folder / "films" / f"{SUITE.tasks[0].id}-fixed-0.rrd"
    assert max(row.step or 0 for row in rows_of(path)["/log"]) == 3
    before = path.stat().st_mtime_ns
    assert list(recorded(folder)) == [(path, False)]
    assert path.stat().st_mtime_ns == before
    assert [each.name for each in path.parent.iterdir()] == [path.name]


def test_without_rerun_the_extra_is_named(folder, monkeypatch):
    monkeypatch.setitem(sys.modules, "rerun", None)
    with pytest.raises(MissingExtra, match=r"recordings for Rerun .*\.\[rerun\]"):
        list(recorded(folder))
    assert not (folder / "films").exists()


@pytest.mark.slow
def test_recordings_that_are_turned_off_are_no_empty_files(folder, monkeypatch):
    pytest.importorskip("rerun")
    monkeypatch.setenv("RERUN", "off")
    with pytest.raises(BadData, match="RERUN: turns all recordings off"):
        list(recorded(folder))
    assert not (folder / "films").exists()


@pytest.mark.parametrize("write", [filmed, pytest.param(recorded, marks=pytest.mark.slow)])
def test_a_forged_record_leaves_no_film(folder, record, write):
    pytest.importorskip("av" if write is filmed else "rerun")
    step = replace(record.steps[0], text=record.steps[0].text.replace("cup", "mug"))
    write_records(folder / "records.jsonl", [replace(record, steps=(step, *record.steps[1:]))])
    with pytest.raises(CantFilm, match="differs in step 1: text"):
        list(write(folder))
    assert not (folder / "films").exists()


@pytest.mark.parametrize("choice", [{"task": "count-45dd8d10"}, {"run": 3}, {"agent": "anna"}])
def test_what_isn_t_there_is_said(folder, choice):
    with pytest.raises(BadData, match="holds no such episode"):
        list(filmed(folder, **choice))


def test_no_speed_is_no_speed(folder):
    with pytest.raises(BadData, match="0 is no speed"):
        list(filmed(folder, speed=0))


def test_without_an_encoder_the_extra_is_named(folder, monkeypatch):
    monkeypatch.setitem(sys.modules, "av", None)
    with pytest.raises(MissingExtra, match=r"Writing films .*\.\[film\]"):
        list(filmed(folder))
