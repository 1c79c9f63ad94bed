"""Runs what a folder lacks of an order: who did what is in the records, which come as they end."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Generator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path

from probe.engines.plan import Engine, LostUnit, WorkPlan
from probe.episodes.files import line_of, read_records, set_aside_cut
from probe.episodes.folder import (
    RECORDS,
    add_line,
    check_for_agents,
    check_suite,
    check_tools_of,
    occupied,
)
from probe.episodes.ordered import note_ordered
from probe.episodes.record import EpisodeRecord
from probe.errors import BadData
from probe.files import check_writable
from probe.runs.plan import Job, RunOrder
from probe.runs.work import WorkerSetup, failed
from probe.tasks.suite import Suite
from probe.tasks.suite_file import content_hash
from probe.toolshed.version import TOOLS_VERSION
from probe.types import Shard


@dataclass(frozen=True)
class RunStart:
    """How a run finds its folder.

    Attributes:
        name: Says which suite and which order it is, whatever the shard.
        jobs: What is left to do.
        done: How much of the order has been done before.
        cut: Where a record that was cut off has been put; None if none was.
    """

    name: str
    jobs: tuple[Job, ...]
    done: int
    cut: Path | None


@contextmanager
def begun(out: Path, suite: Suite, order: RunOrder) -> Generator[RunStart]:
    """Make or take up a folder, for this process alone; nothing is changed if it is refused.

    Raises:
        BadData: It is about another suite, is kept for people's records, was run under other
            conditions, can't be read, or another run is at work there.
        OutputFailed: It can't be written.
    """
    check_folder(out, suite, order)
    with occupied(out, suite):
        cut = set_aside_cut(out / RECORDS)
        note_ordered(out, order.agent, order.setting, order.runs)
        earlier = _earlier(out)
        done = {(it.task, it.agent, it.setting, it.run) for it in earlier if it.end != "fault"}
        jobs = order.jobs(suite.tasks, done)
        yield RunStart(
            name_of(suite, order), tuple(jobs), len(order.jobs(suite.tasks)) - len(jobs), cut
        )


def check_folder(out: Path, suite: Suite, order: RunOrder) -> None:
    """See that a run can begin or go on in a folder; nothing is left there.

    Raises:
        BadData: It is about another suite, is kept for people's records, was run under other
            conditions, or can't be read.
        OutputFailed: It can't be written.
    """
    check_suite(out, suite)
    check_for_agents(out)
    check_settings(out / RECORDS, _earlier(out), order)
    check_writable(out)


def name_of(suite: Suite, order: RunOrder) -> str:
    """A digest of a suite, of how it is run, the shard apart, and of the tools; 32 hex digits."""
    how = repr(replace(order, shard=Shard()))
    said = f"run {content_hash(suite)} {how} tools {TOOLS_VERSION}"
    return hashlib.sha256(said.encode()).hexdigest()[:32]


def work(
    out: Path, start: RunStart, place: WorkerSetup, engine: Engine
) -> Generator[tuple[Job, str | None]]:
    """Run episodes and add their records; yields each with our fault, if it came to nothing.

    Raises:
        OutputFailed: The disk is full; all records that are there are whole.
        WorkerUnfit: A worker couldn't be set up.
        WorkerDied: Workers die before they begin.
    """
    plan = WorkPlan(start.name, place, start.jobs, lambda job: f"{job.task.id}.{job.run}")
    results = engine.carry_out(plan)
    try:
        for job, result in results:
            if isinstance(result, LostUnit):
                result = line_of(failed(job, place.order, result.reason))
            add_line(out, result)
            yield job, _fault(result)
    finally:
        results.close()


def check_settings(path: Path, earlier: Sequence[EpisodeRecord], order: RunOrder) -> None:
    """See that records were made under the conditions of an order.

    Raises:
        BadData: They weren't, or tools of another version made them.
    """
    check_tools_of(path, earlier)
    for record in earlier:
        if record.noise != order.noise:
            raise BadData(path, "was run with another noise", "Choose another folder")
        if record.conditions != order.conditions:
            was = record.conditions.label or "none"
            reason = f"was run under other conditions ({was})"
            raise BadData(path, reason, "Choose another folder")
        if record.perception != order.perception:
            was = record.perception.label or "perception oracle"
            raise BadData(path, f"was run with {was}", "Choose another folder")
        if _counts_otherwise(record, order):
            raise BadData(path, "was run with other --points", "Choose another folder")


def _counts_otherwise(record: EpisodeRecord, order: RunOrder) -> bool:
    """The same model in the same setting, but told to count places in another way."""
    same = (record.agent, record.setting) == (order.agent, order.setting)
    return same and record.participation is not None and record.participation.points != order.points


def _earlier(out: Path) -> list[EpisodeRecord]:
    path = out / RECORDS
    return read_records(path, whole=False) if path.exists() else []


def _fault(line: bytes) -> str | None:
    return json.loads(line)["fault"]
