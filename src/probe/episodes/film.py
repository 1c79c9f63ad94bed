"""What a real camera saw of an episode, kept as files: all that is left of a real table."""

from __future__ import annotations

import itertools
from pathlib import Path

import numpy as np
from PIL import Image

from probe.episodes.motion_pictures import MotionFiles
from probe.files import encode, write_bytes
from probe.station.motion_camera import MotionPicture
from probe.types import Frame

FRAMES = "frames"
"""Folder beside a run's records."""

DEPTH_STEP = 1e-4
"""Metres that one step of a kept depth picture stands for; 0 is a pixel without a reading."""

_QUALITY = 92


class Film:
    """Takes and numbers the pictures of one episode.

    They get a folder that is numbered: a try that is repeated doesn't write over the first one's,
    and a person who sees the names isn't told whose they are.

    Args:
        folder: Of the run.
        task: Id of the episode's task.
    """

    def __init__(self, folder: Path, task: str) -> None:
        taken = {path.name for path in (folder / FRAMES).glob(f"{task}-*")}
        free = (f"{task}-{number:03d}" for number in itertools.count())
        self._folder = folder
        self._name = f"{FRAMES}/{next(name for name in free if name not in taken)}"
        self._count = 0
        self._motions = MotionFiles(folder / self._name)

    def keep(self, frame: Frame) -> str:
        """Write a frame's colours and depth; returns their name in the folder, without an ending.

        Raises:
            OutputFailed: They can't be written.
        """
        assert frame.rgb is not None
        name = f"{self._name}/{self._count:03d}"
        depth = frame.depth if frame.measured is None else np.where(frame.measured, frame.depth, 0)
        steps = np.clip(np.rint(depth / DEPTH_STEP), 0, 2**16 - 1).astype(np.uint16)
        write_bytes(self._folder / f"{name}.depth.png", encode(Image.fromarray(steps), "PNG"))
        picture = encode(Image.fromarray(frame.rgb), "JPEG", quality=_QUALITY)
        write_bytes(self._folder / f"{name}.jpg", picture)
        self._count += 1
        return name

    def keep_motion(self, seen: MotionPicture) -> None:
        """Write a picture of a motion; it belongs to the call after the last kept frame.

        Raises:
            OutputFailed: It can't be written.
        """
        self._motions.keep(seen, max(0, self._count - 1))
