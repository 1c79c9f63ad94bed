"""From the pictures of a robot's episode to a film on disk."""

from __future__ import annotations

from functools import partial
from pathlib import Path

import numpy as np
from PIL import Image, ImageOps

from probe.episodes.grading import grade_episode
from probe.episodes.record import EpisodeRecord
from probe.files import write_bytes
from probe.film.captions import captions_of
from probe.film.cutting import FPS, shots_of
from probe.film.encoding import FilmFormat, encoded, require_encoder
from probe.film.filming import FilmFacts, Watch, composed, cpu_seconds, shown
from probe.film.layout import PAPER, STAGE_PX, Layout
from probe.film.robot_footage import photographed
from probe.tasks.task import Task
from probe.types import Array

INSET = "The table when the arm was last parked"
STILLS_ALONE = "stills alone: no pictures of motions were kept"


def film_robot(
    task: Task,
    record: EpisodeRecord,
    folder: Path,
    path: Path,
    form: FilmFormat = "mp4",
    *,
    speed: float = 1.0,
    watch: Watch = lambda numbers, _: numbers,
) -> FilmFacts:
    """Make a film of what a robot's camera saw; nothing is done again.

    Args:
        task: What the record is about.
        record: Of an episode on a robot.
        folder: Of the run; its pictures lie there.
        path: The film's file, which is written whole or not at all.
        form: Of the file.
        speed: Of motions, of the robot's own.
        watch: Told of each picture.

    Raises:
        BadData: A picture can't be read.
        NoPoses: Whether the answer is right depends on where things lie, which nobody knows.
        MissingExtra: PyAV isn't installed.
        OutputFailed: The file can't be written.
    """
    if form != "gif":
        require_encoder()
    began = cpu_seconds()
    footage = photographed(task, record, folder)
    score = grade_episode(task, record, np.zeros((0, 0), np.int32))
    captions = captions_of(footage.calls, record, score)
    texts = [caption.signs for caption in captions]
    motion = partial(footage.motion, speed=speed)
    shots = shots_of(footage.question, footage.calls, texts, motion)
    places = shown(shots)
    pictures = (_on_stage(footage.pictures[place].pixels()) for place in places)
    assert footage.question.picture is not None
    seen = [footage.question.picture, *(still.pixels() for still in footage.stills[1:])]
    note = "" if footage.moves else STILLS_ALONE
    layout = Layout(footage.question, captions, seen, INSET, note)
    content = encoded(composed(layout, shots, pictures, watch), FPS, form)
    write_bytes(path, content)
    seconds = sum(shot.frames for shot in shots) / FPS
    return FilmFacts(path, seconds, len(places), cpu_seconds() - began)


def _on_stage(picture: Array) -> Array:
    """A picture of any shape as large as the stage allows, uint8, shape (h, w, 3)."""
    return np.asarray(ImageOps.pad(Image.fromarray(picture), STAGE_PX, color=PAPER))
