"""A folder of records and the suite that they are about, for one process or several."""

from __future__ import annotations

import fcntl
import os
from collections.abc import Generator, Iterable
from contextlib import contextmanager
from dataclasses import replace
from itertools import groupby
from pathlib import Path

from probe.episodes.files import append_line, append_record, read_records
from probe.episodes.record import EpisodeRecord
from probe.errors import BadData, OutputFailed
from probe.tasks.suite import Suite
from probe.tasks.suite_file import read_suite, write_suite

RECORDS, SUITE = "records.jsonl", "suite.json"


def start_folder(out: Path, suite: Suite) -> None:
    """Make a folder that records about a suite can be added to, or see that it is one.

    Raises:
        BadData: It is about another suite, or its records can't be read.
        OutputFailed: It can't be written.
    """
    if (out / SUITE).exists() and read_suite(out / SUITE) != suite:
        raise BadData(out / SUITE, "is another suite", "Choose another folder")
    if not (out / SUITE).exists():
        write_suite(out / SUITE, suite)
    if (out / RECORDS).exists():
        read_records(out / RECORDS)


def add_line(out: Path, line: bytes) -> None:
    """Add a record as it is written down, at its end.

    Raises:
        OutputFailed: It can't be written; nothing of it is left.
    """
    with _alone(out):
        append_line(out / RECORDS, line)


def in_order(records: Iterable[EpisodeRecord], suite: Suite) -> list[EpisodeRecord]:
    """Records by task, agent and run, however they were written; none of faults made good since.

    Of several faults of one episode the last is kept.
    """
    places = {task.id: place for place, task in enumerate(suite.tasks)}

    def place(record: EpisodeRecord) -> tuple[int, str, int]:
        return places.get(record.task, len(places)), record.agent, record.run

    kept = list[EpisodeRecord]()
    for key, some in groupby(sorted(records, key=place), key=place):
        of_one = list(some)
        whole = [record for record in of_one if record.end != "fault"]
        # Tasks that aren't in the suite share a place; they are for others to refuse.
        kept += of_one if key[0] == len(places) else whole or of_one[-1:]
    return kept


@contextmanager
def reserved(out: Path) -> Generator[None]:
    """Keep other runs out of a started folder; the lock leaves no file and dies with us.

    Raises:
        BadData: Another run is at work there.
    """
    with (out / SUITE).open("rb") as file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError as error:
            remedy = "Wait for it, or choose another folder"
            raise BadData(out, "another run is at work there", remedy) from error
        yield


def add_run(out: Path, record: EpisodeRecord) -> None:
    """Add a record as the next run of its agent on its task.

    Raises:
        BadData: A record that is there already can't be read.
        OutputFailed: It can't be written; those that were there are still whole.
    """
    path = out / RECORDS
    with _alone(out):
        earlier = read_records(path) if path.exists() else []
        mine = [r.run for r in earlier if (r.task, r.agent) == (record.task, record.agent)]
        append_record(path, replace(record, run=max(mine, default=-1) + 1))


@contextmanager
def _alone(folder: Path) -> Generator[None]:
    """Keep other processes from adding a record; the lock leaves no file and dies with us."""
    try:
        folder.mkdir(parents=True, exist_ok=True)
        handle = os.open(folder, os.O_RDONLY)
    except OSError as error:
        raise OutputFailed(folder, error.strerror or str(error)) from error
    try:
        fcntl.flock(handle, fcntl.LOCK_EX)
        yield
    finally:
        os.close(handle)
