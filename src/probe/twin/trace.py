"""What a twin's arm really does, as lines of a file: for tests of what should stop it."""

from __future__ import annotations

import json
import time
from collections.abc import Generator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import TextIO

import numpy as np

from probe.errors import OutputFailed
from probe.twin.body import Watch
from probe.types import Array

_STILL = 1e-3
"""Radians a second below which a step is only told of now and then."""

_NOW_AND_THEN = 0.1


@dataclass(frozen=True, eq=False)
class Moment:
    """The arm at one step of the physics.

    Attributes:
        clock: time.monotonic() when the step was done, seconds; the same for all processes here.
        joints: Radians, shape (n,).
        speeds: Radians a second, shape (n,).
    """

    clock: float
    joints: Array
    speeds: Array


@contextmanager
def traced(path: Path | None) -> Generator[Watch | None]:
    """Something that appends each step in which the arm moves to a file; None without a path.

    Raises:
        OutputFailed: The file can't be written.
    """
    if path is None:
        yield None
        return
    try:
        file = path.open("a", encoding="utf-8", buffering=1)
    except OSError as error:
        raise OutputFailed(path, error) from error
    with file:
        yield _Writer(file)


class _Writer:
    def __init__(self, file: TextIO) -> None:
        self._file = file
        self._last = 0.0

    def __call__(self, joints: Array, speeds: Array) -> None:
        now = time.monotonic()
        if np.abs(speeds).max() < _STILL and now - self._last < _NOW_AND_THEN:
            return
        self._last = now
        line = [now, joints.round(6).tolist(), speeds.round(6).tolist()]
        self._file.write(json.dumps(line) + "\n")


def read_trace(path: Path) -> list[Moment]:
    """The whole lines of a trace; the last one may be half written."""
    lines = path.read_text("utf-8").split("\n")[:-1]
    return [
        Moment(clock, np.array(joints), np.array(speeds))
        for clock, joints, speeds in map(json.loads, lines)
    ]
