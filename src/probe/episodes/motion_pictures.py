"""Pictures of a robot in motion, as files beside those of its table at rest."""

from __future__ import annotations

import os
from dataclasses import dataclass
from pathlib import Path

import pydantic
from PIL import Image

from probe import reading
from probe.episodes.files import append_line
from probe.episodes.record import EpisodeRecord
from probe.errors import BadData
from probe.files import encode, write_bytes
from probe.station.motion_camera import MotionPicture

MOTION = "motion"
"""Folder of the pictures, and the name of their index, which ends in .jsonl."""

_QUALITY = 80


class _Line(pydantic.BaseModel, extra="forbid", allow_inf_nan=False):
    """A picture; its file has its line's number."""

    step: int = pydantic.Field(ge=0)
    stamp: float = pydantic.Field(ge=0)
    joints: tuple[float, ...]
    moved: float = pydantic.Field(ge=0)


@dataclass(frozen=True)
class KeptMotion:
    """A picture that was kept.

    Attributes:
        path: Of the file, a JPEG.
        step: Number of the call during which it was taken, from 0.
        stamp: When, by the robot's clock, seconds.
        joints: The arm's then, radians.
        moved: For how many seconds the robot had moved in all by then.
    """

    path: Path
    step: int
    stamp: float
    joints: tuple[float, ...]
    moved: float


class MotionFiles:
    """Writes the pictures of one episode's motions.

    Args:
        folder: Of the episode's pictures.
    """

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._count = 0

    def keep(self, seen: MotionPicture, step: int) -> None:
        """Write a picture, and a line about it.

        Raises:
            OutputFailed: It can't be written.
        """
        picture = encode(Image.fromarray(seen.rgb), "JPEG", quality=_QUALITY)
        write_bytes(_file(self._folder, self._count), picture)
        line = _Line(step=step, stamp=seen.stamp, joints=seen.joints, moved=seen.moved)
        append_line(_index(self._folder), line.model_dump_json().encode() + b"\n")
        self._count += 1


def motions_of(record: EpisodeRecord, out: Path) -> tuple[KeptMotion, ...]:
    """The pictures of a robot's motions, in order; none if nobody asked for them.

    Args:
        record: Of an episode on a robot.
        out: Folder of the run.

    Raises:
        BadData: The index can't be read.
    """
    folder = (out / record.frames[0]).parent
    path = _index(folder)
    if not os.path.lexists(path):
        return ()
    try:
        lines = [_Line.model_validate_json(line) for line in _whole_lines(path)]
    except (OSError, pydantic.ValidationError) as error:
        reason = str(error).splitlines()[0]
        raise BadData(path, reason, "Delete it; the film then shows stills alone") from error
    return tuple(
        KeptMotion(_file(folder, number), line.step, line.stamp, line.joints, line.moved)
        for number, line in enumerate(lines)
    )


def _whole_lines(path: Path) -> list[bytes]:
    """A process that was killed may have left half a line at the end."""
    content = reading.contents(path)
    return content[: content.rfind(b"\n") + 1].splitlines()


def _index(folder: Path) -> Path:
    return folder / f"{MOTION}.jsonl"


def _file(folder: Path, number: int) -> Path:
    return folder / MOTION / f"{number:05d}.jpg"
