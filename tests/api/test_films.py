"""Films of a folder: which are made, which are kept, and what is refused."""

from __future__ import annotations

import sys
from dataclasses import replace
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest

from probe.agents.scripted import Scripted
from probe.api import films
from probe.api.films import Clip, clipped, filmed, recorded
from probe.cli.report import write_run_report
from probe.episodes.circumstances import Circumstances
from probe.episodes.conditions import Conditions
from probe.episodes.files import write_records
from probe.episodes.participation import ModelReply, Participation
from probe.episodes.play import play
from probe.episodes.turns import Call
from probe.errors import BadData, MissingExtra, OutputFailed
from probe.film import footage
from probe.film.cutting import FPS
from probe.film.footage import CantFilm
from probe.film.layout import SIZE_PX, STAGE_PX
from probe.render import driver
from probe.render.renderer import Renderer
from probe.report.clips import clip_stem
from probe.scene.seeds import generator
from probe.scene.setup import RendererName
from probe.tasks.suite import selection
from probe.tasks.suite_file import demo_suite, write_suite
from probe.toolshed.result import MOVING
from recordings import rows_of
from run_folders import episode, write_run

SUITE = demo_suite()
INSET_PX = 344
"""Sides of what the agent saw, in a film."""

CALLS = (
    Call.of("perceive_scene"),
    Call.of("push", {"object_id": "object_99", "direction": "left", "distance_cm": 5}),
    Call.of("answer_question", {"choice": "E"}),
)


class Fixed:
    """Looks, pushes what isn't there, and answers."""

    def act(self, question, history):
        return CALLS[len(history)] if len(history) < len(CALLS) else None


class Guess:
    """Answers at once."""

    def act(self, question, history):
        return None if history else CALLS[-1]


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


@pytest.fixture
def not_drawn(monkeypatch):
    """Recordings and clips are files without content."""
    monkeypatch.setattr(films, "_own", lambda *_: None)
    monkeypatch.setattr(films, "write_recording", lambda *given: films.write_bytes(given[-1], b""))
    monkeypatch.setattr(films, "clips_of", lambda *_, **__: [Clip(n, b"", 1.0) for n in (1, 2)])


def test_each_episode_has_a_file_of_its_own(folder, record, not_drawn):
    called = (ModelReply(len(record.steps)),)
    several = [
        record,
        *(replace(record, agent=name) for name in ("Anna_B", "Anna B")),
        *(
            replace(record, agent="mine", participation=Participation(setting, replies=called))
            for setting in ("agentic", "text-only", "text-only, short graphs")
        ),
    ]
    write_records(folder / "records.jsonl", several)
    made = list(recorded(folder))
    assert all(new for _, new in made) and len({path for path, _ in made}) == len(several)
    names = [path.stem.removeprefix(f"{SUITE.tasks[0].id}-") for path, _ in made]
    assert names[:2] == ["fixed-0", "Anna_B-0"]
    assert names[2].startswith("Anna_B-0-")
    assert names[3:5] == ["mine-0-agentic", "mine-0-text-only"]
    assert names[5].startswith("mine-0-text-only__short_graphs-")
    assert list(recorded(folder)) == [(path, False) for path, _ in made]


def test_clips_that_were_cut_short_are_finished(tmp_path, not_drawn, monkeypatch):
    write_run(tmp_path, [episode(SUITE.tasks[0])], pictures=False)
    write = films.write_bytes

    def full(path: Path, content: bytes) -> None:
        if any(path.parent.glob("*.webm")):
            raise OutputFailed(path, OSError(28, "No space left on device"))
        write(path, content)

    with monkeypatch.context() as short:
        short.setattr(films, "write_bytes", full)
        with pytest.raises(OutputFailed):
            list(clipped(tmp_path))
    assert [made for _, made in clipped(tmp_path)] == [2]
    assert [path.suffix for path in (tmp_path / "clips").iterdir()] == [".webm"] * 2
    assert [made for _, made in clipped(tmp_path)] == [0]


@pytest.mark.slow
def test_a_recording_is_made_once_and_kept(folder):
    pytest.importorskip("rerun")
    ((path, made),) = recorded(folder)
    assert made and path == folder / "films" / f"{SUITE.tasks[0].id}-fixed-0.rrd"
    assert max(row.step or 0 for row in rows_of(path)["/log"]) == len(CALLS) + 1
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


@pytest.fixture
def no_blender(monkeypatch):
    driver.require_blender.cache_clear()
    monkeypatch.setattr(driver, "find_spec", lambda name: None)
    yield
    driver.require_blender.cache_clear()


# Rerun is installed with what the slow tests need.
@pytest.mark.parametrize("make", [filmed, clipped, pytest.param(recorded, marks=pytest.mark.slow)])
def test_without_blender_its_record_is_refused_in_words(folder, record, no_blender, make):
    pytest.importorskip("rerun" if make is recorded else "av")
    write_records(folder / "records.jsonl", [by_blender(record)])
    with pytest.raises(MissingExtra, match=r"Drawing with Blender .*\.\[blender\]"):
        list(make(folder))
    assert {path.name for path in folder.iterdir()} == {"suite.json", "records.jsonl"}


def by_blender(record):
    """The record as if Blender had drawn its pictures, on request."""
    viewpoint = replace(record.viewpoint, renderer="blender")
    return replace(record, viewpoint=viewpoint, conditions=Conditions(renderer="blender"))


@pytest.mark.parametrize("make", [filmed, clipped])
def test_without_blender_it_is_known_before_an_episode_is_done_again(
    folder, no_blender, monkeypatch, make
):
    pytest.importorskip("av")
    monkeypatch.setattr(footage, "set_table", None)
    with pytest.raises(MissingExtra, match=r"Drawing with Blender .*\.\[blender\]"):
        list(make(folder, renderer="blender"))


def smaller(task, picture_px):
    """The task on a table whose camera takes smaller pictures."""
    setup = replace(task.setup, name="small", picture_px=picture_px)
    return replace(task, scene=replace(task.scene, setup=setup))


@pytest.mark.slow
@pytest.mark.skipif(find_spec("bpy") is None, reason="Blender's package isn't installed")
def test_a_record_of_blenders_is_filmed_by_either(folder, library):
    av = pytest.importorskip("av")
    # As small as the inset is: each of the usual camera's pictures takes Blender half a minute.
    task, asked = smaller(SUITE.tasks[0], INSET_PX), Conditions(renderer="blender")
    seen = Circumstances(conditions=asked, viewpoint=replace(task.viewpoint, renderer="blender"))
    write_suite(folder / "suite.json", selection(SUITE, (task,), "small"))
    with Renderer(engine="blender") as blender:
        record = play(task, Guess(), "fixed", library, blender, seen)
    write_records(folder / "records.jsonl", [record])
    name, films = f"{SUITE.tasks[0].id}-fixed-0", []
    wanted: dict[RendererName, str] = {"filament": f"{name}.mp4", "blender": f"{name}-blender.mp4"}
    for renderer, path in wanted.items():
        (facts,) = filmed(folder, renderer=renderer)
        assert facts.path == folder / "films" / path
        with av.open(facts.path) as film:
            assert film.metadata["comment"] == f"Stage drawn by {renderer}"
            films.append(next(film.decode(video=0)).to_ndarray(format="rgb24").astype(int))
    # Robot, table and room stand in the same places, in somewhat other shades.
    left = slice(SIZE_PX[1] - STAGE_PX[1], None), slice(STAGE_PX[0])
    one, other = (film[left].mean(axis=2) for film in films)
    assert np.corrcoef(one.ravel(), other.ravel())[0, 1] > 0.9
    assert np.abs(one - other).mean() > 1
    # What the agent saw is the same picture, encoded twice; the engines' own differ by 8.
    inset = slice(200, 400), slice(STAGE_PX[0] + 60, None)
    assert np.abs(films[0][inset] - films[1][inset]).mean() < 2


def test_a_robots_film_has_no_renderer(folder, record):
    scene = replace(record.start.scene, objects=())
    bare = replace(record.start, scene=scene)
    steps = tuple(replace(step, after=replace(step.after, scene=scene)) for step in record.steps)
    frames = tuple(f"frames/{SUITE.tasks[0].id}-000/{n:03}" for n in range(len(steps) + 1))
    write_records(
        folder / "records.jsonl", [replace(record, start=bare, steps=steps, frames=frames)]
    )
    with pytest.raises(BadData, match=r"--renderer blender: draws nothing of .*camera's pictures"):
        list(filmed(folder, renderer="blender"))


def test_no_speed_is_no_speed(folder):
    with pytest.raises(BadData, match="0 is no speed"):
        list(filmed(folder, speed=0))


def test_without_an_encoder_the_extra_is_named(folder, monkeypatch):
    monkeypatch.setitem(sys.modules, "av", None)
    with pytest.raises(MissingExtra, match=r"Writing films .*\.\[film\]"):
        list(filmed(folder))
