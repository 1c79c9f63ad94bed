"""A robot's episode as it was photographed: what a film of it is cut from."""

from __future__ import annotations

import io
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from PIL import Image

from probe.episodes.grading import question_of
from probe.episodes.motion_pictures import motions_of
from probe.episodes.record import EpisodeRecord
from probe.episodes.turns import Question
from probe.errors import BadData
from probe.film.cutting import FPS, Moving
from probe.film.footage import FilmedCall
from probe.reading import contents
from probe.tasks.task import Task
from probe.toolshed.result import ToolResult
from probe.types import Array

_LAST = 0.25
"""Seconds that the last picture of a call's motions stands."""


@dataclass(frozen=True)
class RobotPicture:
    """A picture that was kept.

    Attributes:
        path: Of the file.
        moved: For how many seconds the robot had moved in all by then; None of a table at rest.
    """

    path: Path
    moved: float | None = None

    def pixels(self) -> Array:
        """Its colours, uint8, shape (h, w, 3).

        Raises:
            BadData: It can't be read.
        """
        try:
            return np.asarray(Image.open(io.BytesIO(contents(self.path))).convert("RGB"))
        except OSError as error:
            remedy = "Keep a robot's folder of frames beside its records"
            raise BadData(self.path, error.strerror or str(error), remedy) from error


@dataclass(frozen=True, eq=False)
class RobotFootage:
    """An episode on a robot, in pictures.

    Attributes:
        question: What was asked, with the first picture.
        pictures: The table at the start; then for each call the pictures of its motions, and the
            table after it.
        calls: In order; their moments are places in `pictures`.
    """

    question: Question
    pictures: tuple[RobotPicture, ...]
    calls: tuple[FilmedCall, ...]

    @property
    def stills(self) -> tuple[RobotPicture, ...]:
        """The table at the start and after each call."""
        return tuple(picture for picture in self.pictures if picture.moved is None)

    @property
    def moves(self) -> bool:
        """Whether there are pictures of any motion."""
        return len(self.stills) < len(self.pictures)

    def motion(self, first: int, last: int, speed: float) -> Iterator[Moving]:
        """The pictures between two of the table at rest, each for as long as the robot moved on.

        Args:
            first: Place of the first one at rest.
            last: Of the second.
            speed: Of the robot's own.
        """
        times = [self.pictures[place].moved or 0.0 for place in range(first + 1, last)]
        stands = [later - now for now, later in zip(times, times[1:], strict=False)] + [_LAST]
        until, done = 0.0, 0
        for place, seconds in zip(range(first + 1, last), stands, strict=False):
            until += seconds / speed
            frames = round(FPS * until) - done
            done += frames
            if frames > 0:
                yield place, speed, frames


def photographed(task: Task, record: EpisodeRecord, folder: Path) -> RobotFootage:
    """The pictures of a record, by its calls.

    Args:
        task: What it is about.
        record: Of an episode on a robot.
        folder: Of the run.

    Raises:
        BadData: A picture can't be read.
    """
    motions = motions_of(record, folder)
    pictures = [RobotPicture(folder / f"{record.frames[0]}.jpg")]
    calls: list[FilmedCall] = []
    for number, step in enumerate(record.steps):
        first = len(pictures) - 1
        mine = [RobotPicture(each.path, each.moved) for each in motions if each.step == number]
        pictures += [*mine, RobotPicture(folder / f"{record.frames[number + 1]}.jpg")]
        result = ToolResult(step.text, status=step.status, point_px=step.point_px)
        calls.append(FilmedCall(step.call, result, first, len(pictures) - 1))
    question = question_of(task, pictures[0].pixels())
    return RobotFootage(question, tuple(pictures), tuple(calls))
