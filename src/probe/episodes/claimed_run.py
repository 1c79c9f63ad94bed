"""The number of a run, kept for one process from the first look at the table to the record."""

from __future__ import annotations

import fcntl
import hashlib
import os
import struct
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO

from probe.episodes.files import read_records
from probe.episodes.folder import RECORDS, SUITE
from probe.episodes.ordered import MOST_RUNS
from probe.errors import BadData, OutputFailed
from probe.files import alone

_FLOCK = "hhqqi4x"
"""C's struct flock: kind of lock, whence, start, length, process."""


@contextmanager
def claimed_run(out: Path, task: str, agent: str) -> Generator[int]:
    """Keep the number of an agent's next run at a task from other processes during the block.

    It is the first one that has no result and that nobody else plays. So the number of a session
    that leaves no record, or whose record is of a fault, is given again. The lock leaves no file
    and dies with us.

    Args:
        out: A started folder.
        task: Id of the task.
        agent: Who acts, for the record; not a model that has a setting.

    Raises:
        BadData: A record that is there already can't be read, or no number is left.
        OutputFailed: The folder can't be written.
    """
    try:
        file = (out / SUITE).open("r+b", buffering=0)
    except OSError as error:
        raise OutputFailed(out / SUITE, error) from error
    with file:
        # Whoever ends a claim has added its record before, so that it is read here.
        with alone(out):
            done, first = _done(out, task, agent), _place(task, agent)
            runs = (run for run in range(MOST_RUNS) if run not in done)
            run = next((run for run in runs if _locked(file, first + run)), None)
        if run is None:
            remedy = "Choose another folder"
            raise BadData(out, f"has {MOST_RUNS} runs of {agent} at {task} already", remedy)
        yield run


def _done(out: Path, task: str, agent: str) -> set[int]:
    path = out / RECORDS
    earlier = read_records(path) if path.exists() else []
    mine = [it for it in earlier if (it.task, it.agent, it.setting) == (task, agent, "")]
    return {it.run for it in mine if it.end != "fault"}


def _place(task: str, agent: str) -> int:
    """Where an agent's runs at a task begin: bytes that are locked needn't be in the file."""
    digest = hashlib.sha256(f"{task}\n{agent}".encode()).digest()
    return int.from_bytes(digest[:5], "big") * MOST_RUNS


def _locked(file: BinaryIO, place: int) -> bool:
    """Whether a byte of a file could be locked; an open file has its locks, not a process."""
    asked = struct.pack(_FLOCK, fcntl.F_WRLCK, os.SEEK_SET, place, 1, 0)
    try:
        fcntl.fcntl(file, fcntl.F_OFD_SETLK, asked)
    except BlockingIOError:
        return False
    except OSError as error:  # a file system without locks
        raise OutputFailed(file.name, error) from error
    return True
