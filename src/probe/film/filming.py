"""From a record to a film on disk."""

from __future__ import annotations

import resource
import time
from collections.abc import Callable, Generator, Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from probe.assets.library import Library
from probe.episodes.play import score
from probe.episodes.record import EpisodeRecord
from probe.files import write_bytes
from probe.film.captions import captions_of
from probe.film.cutting import FPS, FilmShot, cut
from probe.film.drawing import stage_drawer
from probe.film.encoding import FilmFormat, encoded, require_encoder
from probe.film.footage import take
from probe.film.layout import STAGE_PX, Layout
from probe.render.renderer import Renderer
from probe.scene.setup import RendererName
from probe.stage.cameras import whole_view
from probe.tasks.task import Task
from probe.types import Array

Watch = Callable[[Iterable[int], int], Iterable[int]]
"""Goes through numbers, of which there are so many, and may show how far it is."""


@dataclass(frozen=True)
class FilmFacts:
    """A film on disk, and what it took.

    Attributes:
        path: The file.
        seconds: How long it runs.
        drawn: Pictures of the stage that it shows; 0 if it was there already, and then the
            rest isn't told.
        cpu_seconds: What drawing and encoding took of this process and the renderer's.
    """

    path: Path
    seconds: float
    drawn: int
    cpu_seconds: float


def film(
    task: Task,
    record: EpisodeRecord,
    library: Library,
    renderer: Renderer,
    path: Path,
    form: FilmFormat = "mp4",
    *,
    stage: RendererName = "filament",
    speed: float = 1.0,
    watch: Watch = lambda numbers, _: numbers,
) -> FilmFacts:
    """Film an episode: done again, compared with its record, drawn, encoded.

    Args:
        task: What the record is about.
        record: The episode.
        library: Has the task's objects.
        renderer: Draws what the station sees, so it is the record's kind; what was loaded in it is
            replaced. The stage has one of its own.
        path: The film's file, which is written whole or not at all.
        form: Of the file.
        stage: What draws the stage; the file says so.
        speed: Of motions other than closing fingers, of life's.
        watch: Told of each picture that is drawn.

    Raises:
        CantFilm: The episode can't be done again, or not as it was.
        OtherTools: Tools of another version made the record.
        MissingExtra: PyAV isn't installed, or Blender where it is to draw.
        OutputFailed: The file can't be written.
    """
    if form != "gif":
        require_encoder()
    footage = take(task, record, library, renderer)
    captions = captions_of(footage.calls, record, score(task, record, renderer))
    shots = cut(footage, speed, [caption.signs for caption in captions])
    began = cpu_seconds()
    with stage_drawer(task.scene, library, stage) as drawer:
        camera = whole_view(task.setup, *STAGE_PX)
        moments = [footage.moments[number] for number in shown(shots)]
        pictures = (picture for _, picture in drawer.draw_all(moments, camera))
        layout = Layout(footage.question, captions, footage.pictures)
        frames = composed(layout, shots, pictures, watch)
        content = encoded(frames, FPS, form, drawn_by(stage))
    write_bytes(path, content)
    seconds = sum(shot.frames for shot in shots) / FPS
    return FilmFacts(path, seconds, len(moments), cpu_seconds() - began)


def drawn_by(stage: RendererName) -> str:
    """What a file says of its pictures."""
    return f"Stage drawn by {stage}"


def shown(shots: Sequence[FilmShot]) -> list[int]:
    """The moments of shots, in order; one that several neighbours show is drawn once."""
    moments = [shot.moment for shot in shots]
    return [now for before, now in zip([None, *moments], moments, strict=False) if now != before]


def composed(
    layout: Layout, shots: Sequence[FilmShot], pictures: Iterator[Array], watch: Watch
) -> Generator[tuple[Array, int]]:
    """Whole frames, and how long each stands; pictures are of the stage, as shown() says."""
    stage, moment = next(pictures), shots[0].moment
    for number in watch(range(len(shots)), len(shots)):
        shot = shots[number]
        if shot.moment != moment:
            stage, moment = next(pictures), shot.moment
        yield layout.frame(shot, stage), shot.frames


def cpu_seconds() -> float:
    """Of this process and of children that have ended."""
    ended = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.process_time() + ended.ru_utime + ended.ru_stime
