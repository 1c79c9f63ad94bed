"""Records of run folders, with their tasks and what they are worth."""

from __future__ import annotations

from pathlib import Path

from probe.api.progress import Track, silent
from probe.api.resources import everything
from probe.episodes.folder import SUITE, in_order
from probe.episodes.record import EpisodeRecord
from probe.report.scene_renderer import SceneRenderer
from probe.runs.checks.folder import read_checked
from probe.tasks.grading import Score
from probe.tasks.suite import Suite
from probe.tasks.suite_file import read_suite
from probe.tasks.task import Task

Graded = tuple[Task, EpisodeRecord, Score]


def graded(out: Path, track: Track = silent) -> list[Graded]:
    """Every record of a folder with its task and what it is worth, by task, agent and run.

    Raises:
        BadData: The suite or a record can't be read, or a record can't be of a run of the suite.
        OtherTask: A task has changed since.
    """
    suite = read_suite(out / SUITE)
    with scene_renderer_of(suite) as scene_renderer:
        return grade_folder(out, suite, scene_renderer, track)


def scene_renderer_of(suite: Suite) -> SceneRenderer:
    """A place to draw a suite's tables in, with all objects that suites are made of."""
    return SceneRenderer(suite, everything)


def grade_folder(
    out: Path, suite: Suite, scene_renderer: SceneRenderer, track: Track = silent
) -> list[Graded]:
    """As `graded`, of a suite that has been read; each task's objects are loaded but once."""
    tasks = {task.id: task for task in suite.tasks}
    records = in_order(read_checked(out, suite), suite)
    places = sorted(range(len(records)), key=lambda place: records[place].task)
    scores = {
        place: scene_renderer.score(tasks[records[place].task], records[place])
        for place in track(places, f"Grading {out.name}")
    }
    return [(tasks[it.task], it, scores[place]) for place, it in enumerate(records)]
