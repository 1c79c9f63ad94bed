"""Films of a folder's episodes, clips of their manipulations, and recordings for Rerun's viewer."""

from __future__ import annotations

from collections.abc import Generator
from pathlib import Path

from probe.api.resources import everything
from probe.assets.library import Library
from probe.episodes.folder import SUITE
from probe.episodes.record import EpisodeRecord
from probe.errors import BadData
from probe.files import write_bytes
from probe.film.clips import Clip, clips_of
from probe.film.encoding import FilmFormat
from probe.film.filming import FilmFacts, Watch
from probe.film.filming import film as _film
from probe.film.recording.recording import write_recording
from probe.film.robot_filming import film_robot
from probe.render.renderer import Renderer
from probe.render.renderers import Renderers
from probe.report.clips import CLIPS, clip_stem
from probe.runs.checks.folder import read_checked
from probe.tasks.suite import Suite, check_objects, part
from probe.tasks.suite_file import read_suite
from probe.tasks.task import Task
from probe.toolshed.result import MOVING

__all__ = ["Clip", "clipped", "clips_of", "filmed", "recorded"]

FILMS = "films"
"""Folder beside the records."""


def filmed(
    folder: str | Path,
    out: str | Path | None = None,
    *,
    task: str | None = None,
    run: int | None = None,
    agent: str | None = None,
    form: FilmFormat = "mp4",
    speed: float = 1.0,
    watch: Watch = lambda numbers, _: numbers,
) -> Generator[FilmFacts]:
    """Film episodes of a folder one after another; yields each as it is there.

    What was done on a simulated table is done again; of a robot's, the kept pictures are shown.

    Args:
        folder: Holds suite.json and records.jsonl.
        out: Folder for the films; by default "films" beside the records. What is there is kept.
        task: Id of a task; by default all.
        run: Number of a run; by default all.
        agent: Name of an agent; by default all.
        form: Of the files.
        speed: Of motions other than closing fingers, of life's.
        watch: Told of each picture.

    Raises:
        BadData: The folder can't be read, or holds no such episode.
        CantFilm: An episode can't be done again, or not as it was.
        OtherTools: Tools of another version made it.
        NoPoses: Whether a robot's answer is right depends on where things lie.
        MissingExtra: PyAV isn't installed.
    """
    if speed <= 0:
        raise BadData("--speed", f"{speed:g} is no speed", "Say more than 0")
    place = Path(folder)
    suite, chosen = _chosen(place, task, run, agent)
    things = everything()
    with Renderers(things.light_cache) as drawing:
        for record in chosen:
            path = _path(place, out, record, form)
            if path.exists():
                yield FilmFacts(path, 0.0, 0, 0.0)
            elif record.frames:
                asked = suite[record.task]
                yield film_robot(asked, record, place, path, form, speed=speed, watch=watch)
            else:
                asked, paint = _asked(suite, record, things), drawing["filament"]
                yield _film(asked, record, things, paint, path, form, speed=speed, watch=watch)


def recorded(
    folder: str | Path,
    out: str | Path | None = None,
    *,
    task: str | None = None,
    run: int | None = None,
    agent: str | None = None,
) -> Generator[tuple[Path, bool]]:
    """Write episodes of a folder as recordings for Rerun's viewer, one after another.

    Yields the path of each, and whether it was made now.

    Args:
        folder: Holds suite.json and records.jsonl.
        out: Folder for the recordings; by default "films" beside the records. What is there is
            kept.
        task: Id of a task; by default all.
        run: Number of a run; by default all.
        agent: Name of an agent; by default all.

    Raises:
        BadData, CantFilm, OtherTools, MissingExtra: As filmed().
    """
    place = Path(folder)
    suite, chosen = _chosen(place, task, run, agent)
    things = everything()
    with Renderer(things.light_cache) as drawing:
        for record in chosen:
            path = _path(place, out, record, "rrd")
            missing = not path.exists()
            if missing:
                write_recording(_asked(suite, record, things), record, things, drawing, path)
            yield path, missing


def clipped(
    folder: str | Path, *, task: str | None = None, run: int | None = None, agent: str | None = None
) -> Generator[tuple[EpisodeRecord, int]]:
    """Write a short loop of each manipulation for a folder's report, into "clips" beside records.

    Yields each episode that has manipulations, and how many clips were made of it; none if it has
    some already. A call that moved nothing gets none.

    Args:
        folder: Holds suite.json and records.jsonl.
        task: Id of a task; by default all.
        run: Number of a run; by default all.
        agent: Name of an agent; by default all.

    Raises:
        BadData, CantFilm, OtherTools, MissingExtra: As filmed().
    """
    place = Path(folder)
    suite, chosen = _chosen(place, task, run, agent)
    things = everything()
    with Renderer(things.light_cache) as drawing:
        for record in chosen:
            moving = [n for n, step in enumerate(record.steps, start=1) if step.call.name in MOVING]
            paths = {n: place / CLIPS / f"{clip_stem(record, n)}.webm" for n in moving}
            if not moving:
                continue
            if any(path.exists() for path in paths.values()):
                yield record, 0
                continue
            clips = clips_of(_asked(suite, record, things), record, things, drawing)
            for clip in clips:
                write_bytes(paths[clip.call + 1], clip.content)
            yield record, len(clips)


def _chosen(
    place: Path, task: str | None, run: int | None, agent: str | None
) -> tuple[Suite, list[EpisodeRecord]]:
    suite = read_suite(place / SUITE)
    wanted = [record for record in read_checked(place, suite) if record.end != "fault"]
    for name, value in (("task", task), ("run", run), ("agent", agent)):
        if value is not None:
            wanted = [record for record in wanted if getattr(record, name) == value]
    if not wanted:
        raise BadData(place, "holds no such episode", "Look into `probe report` for what there is")
    return suite, wanted


def _asked(suite: Suite, record: EpisodeRecord, things: Library) -> Task:
    """An episode's task, whose objects are what they were when the suite was made."""
    task = suite[record.task]
    check_objects(part(suite, task), things)
    return task


def _path(place: Path, out: str | Path | None, record: EpisodeRecord, ending: str) -> Path:
    """An episode's file, with a name of signs that every disk takes."""
    named = f"{record.task}-{record.agent}-{record.run}"
    name = "".join(sign if sign.isalnum() or sign in "-_." else "_" for sign in named)
    return Path(out or place / FILMS) / f"{name}.{ending}"
