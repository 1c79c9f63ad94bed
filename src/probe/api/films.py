"""Films of a folder's episodes, clips of their manipulations, and recordings for Rerun's viewer."""

from __future__ import annotations

import hashlib
from collections.abc import Generator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
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
from probe.scene.setup import RendererName
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
    renderer: RendererName = "filament",
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
        renderer: Draws robot, table and room. What the agent saw is drawn as the record says.
        speed: Of motions other than closing fingers, of life's.
        watch: Told of each picture.

    Raises:
        BadData: The folder can't be read, or holds no such episode.
        CantFilm: An episode can't be done again, or not as it was.
        OtherTools: Tools of another version made it.
        NoPoses: Whether a robot's answer is right depends on where things lie.
        MissingExtra: PyAV isn't installed, or Blender where it is to draw.
    """
    if speed <= 0:
        raise BadData("--speed", f"{speed:g} is no speed", "Say more than 0")
    chosen = _Episodes.of(folder, task, run, agent)
    shown = partial(_film, form=form, stage=renderer, speed=speed, watch=watch)
    with Renderers(chosen.things.light_cache) as drawing:
        for record in chosen.records:
            path = chosen.path(out, record, form, renderer)
            if path.exists():
                yield FilmFacts(path, 0.0, 0, 0.0)
            elif record.frames:
                _refuse_stage(record, renderer)
                asked = chosen.suite[record.task]
                yield film_robot(asked, record, chosen.place, path, form, speed=speed, watch=watch)
            else:
                own = _own(drawing, record, renderer)
                yield shown(chosen.asked(record), record, chosen.things, own, path)


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
    chosen = _Episodes.of(folder, task, run, agent)
    with Renderers(chosen.things.light_cache) as drawing:
        for record in chosen.records:
            path = chosen.path(out, record, "rrd")
            missing = not path.exists()
            if missing:
                own = _own(drawing, record)
                write_recording(chosen.asked(record), record, chosen.things, own, path)
            yield path, missing


def clipped(
    folder: str | Path,
    *,
    task: str | None = None,
    run: int | None = None,
    agent: str | None = None,
    renderer: RendererName = "filament",
) -> Generator[tuple[EpisodeRecord, int]]:
    """Write a short loop of each manipulation for a folder's report, into "clips" beside records.

    Yields each episode that has manipulations, and how many clips were made of it; none if it has
    them already. A call that moved nothing gets none.

    Args:
        folder: Holds suite.json and records.jsonl.
        task: Id of a task; by default all.
        run: Number of a run; by default all.
        agent: Name of an agent; by default all.
        renderer: As in filmed().

    Raises:
        BadData, CantFilm, OtherTools, MissingExtra: As filmed().
    """
    chosen = _Episodes.of(folder, task, run, agent)
    with Renderers(chosen.things.light_cache) as drawing:
        for record in chosen.records:
            moving = [n for n, step in enumerate(record.steps, start=1) if step.call.name in MOVING]
            paths = {n: chosen.place / CLIPS / f"{clip_stem(record, n)}.webm" for n in moving}
            if not moving:
                continue
            unfinished = paths[moving[0]].with_suffix(".unfinished")
            if any(path.exists() for path in paths.values()) and not unfinished.exists():
                yield record, 0
                continue
            own = _own(drawing, record, renderer)
            clips = clips_of(chosen.asked(record), record, chosen.things, own, stage=renderer)
            _write_all({paths[clip.call + 1]: clip.content for clip in clips}, unfinished)
            yield record, len(clips)


def _write_all(contents: Mapping[Path, bytes], unfinished: Path) -> None:
    """Write files; the one that says that they are unfinished is there until all are written."""
    if contents:
        write_bytes(unfinished, b"")
        for path, content in contents.items():
            write_bytes(path, content)
        unfinished.unlink(missing_ok=True)


def _own(drawing: Renderers, record: EpisodeRecord, stage: RendererName = "filament") -> Renderer:
    """What drew the pictures of an episode, which sees to it that the stage can be drawn, too."""
    drawing.require(stage)
    return drawing[record.viewpoint.renderer]


def _refuse_stage(record: EpisodeRecord, stage: RendererName) -> None:
    if stage != "filament":
        reason = f"draws nothing of {record.task}, run {record.run} of {record.agent}"
        remedy = "A robot's film is made of its camera's pictures: leave the option out"
        raise BadData(f"--renderer {stage}", reason, remedy)


@dataclass(frozen=True)
class _Episodes:
    """Those episodes of a folder that were asked for.

    Attributes:
        place: The folder.
        suite: Its suite.
        records: Of the episodes; at least one.
        things: All objects that there are.
    """

    place: Path
    suite: Suite
    records: Sequence[EpisodeRecord]
    things: Library

    @staticmethod
    def of(folder: str | Path, task: str | None, run: int | None, agent: str | None) -> _Episodes:
        """Read a folder.

        Raises:
            BadData: The folder can't be read, or holds no such episode.
        """
        place = Path(folder)
        suite = read_suite(place / SUITE)
        wanted = [record for record in read_checked(place, suite) if record.end != "fault"]
        for name, value in (("task", task), ("run", run), ("agent", agent)):
            if value is not None:
                wanted = [record for record in wanted if getattr(record, name) == value]
        if not wanted:
            remedy = "Look into `probe report` for what there is"
            raise BadData(place, "holds no such episode", remedy)
        return _Episodes(place, suite, wanted, everything())

    def asked(self, record: EpisodeRecord) -> Task:
        """An episode's task, whose objects are what they were when the suite was made."""
        task = self.suite[record.task]
        check_objects(part(self.suite, task), self.things)
        return task

    def path(
        self,
        out: str | Path | None,
        record: EpisodeRecord,
        ending: str,
        stage: RendererName = "filament",
    ) -> Path:
        """An episode's file, with a name of signs that every disk takes."""
        drawn = "" if stage == "filament" else f"-{stage}"
        setting = f"-{record.setting}" if record.setting else ""
        name = _file_name(f"{record.task}-{record.agent}-{record.run}{setting}")
        return Path(out or self.place / FILMS) / f"{name}{drawn}.{ending}"


def _file_name(named: str) -> str:
    """With other signs replaced; a digest then tells it from names that become the same."""
    name = "".join(sign if sign.isalnum() or sign in "-_." else "_" for sign in named)
    digest = hashlib.sha256(named.encode()).hexdigest()[:8]
    return name if name == named else f"{name}-{digest}"
