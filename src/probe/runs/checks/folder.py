"""Reads a folder's records and refuses those that no run of its suite can have written.

The one place where records and suite meet: whoever grades a folder reads it here.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial
from pathlib import Path

from probe.episodes.conditions import Conditions
from probe.episodes.files import lines_of, records_of
from probe.episodes.folder import RECORDS, SUITE
from probe.episodes.grading import answer_form, budget_of
from probe.episodes.ordered import read_ordered
from probe.episodes.record import EpisodeRecord
from probe.errors import BadData
from probe.runs.checks.calls import amiss_in_calls
from probe.runs.checks.ending import amiss_at_the_end
from probe.runs.checks.stated import amiss_as_stated, amiss_beside_task
from probe.runs.checks.varied import difference_under
from probe.runs.variation import VARIATION, Variation, digest_of_tasks, read_variation
from probe.runs.vary import changes_scenes
from probe.tasks.suite import Suite
from probe.tasks.suite_file import check_name, packaged_suite, packaged_suites
from probe.tasks.task import Task
from probe.toolshed.answer_form import ANY_ANSWER, AnswerForm
from probe.toolshed.version import ANSWERS_CHECKED

_REMEDY = "Grade the folder as its run left it (docs/how-to/audit.md says what is checked)"

_Found = Iterator[tuple[int, str]]
"""Numbers of lines, from 1, and what is amiss there."""


def read_checked(out: Path, suite: Suite) -> list[EpisodeRecord]:
    """All records of a folder, in the order of its file.

    Args:
        out: The folder.
        suite: Its suite, which has been read.

    Raises:
        BadData: A record can't be read, or can't have come of a run of the suite; or the suite
            bears the name of a packaged one that it isn't.
    """
    return [record for _, record in read_checked_lines(out, suite)]


def read_checked_lines(out: Path, suite: Suite) -> list[tuple[bytes, EpisodeRecord]]:
    """As read_checked, each record with its line: both are of one look at the file."""
    path = out / RECORDS
    lines = lines_of(path)
    records = records_of(path, lines)
    check_records(records, suite, path)
    _refuse(_of_folder(records, out), records, path)
    check_suite_of(out, suite, records)
    return list(zip(lines, records, strict=True))


def check_records(records: Sequence[EpisodeRecord], suite: Suite, path: Path) -> None:
    """Refuse records that no run of a suite can have written, each for itself.

    Args:
        records: All of a file, in its order.
        suite: What they are about.
        path: The file, for the message.

    Raises:
        BadData: One is of no task of the suite, or doesn't agree with its task or with itself.
    """
    tasks = {task.id: task for task in suite.tasks}
    for record in records:
        if record.task not in tasks:
            remedy = "Move one of them elsewhere"
            raise BadData(path, f"{record.task} is not in {SUITE}", remedy)
    _refuse(_of_records(records, tasks), records, path)


def check_suite_of(out: Path, suite: Suite, records: Sequence[EpisodeRecord]) -> None:
    """Refuse a folder's suite that bears a packaged one's name, or nearly, and isn't made from it.

    Args:
        out: The folder.
        suite: Its suite.
        records: Its records; they say under which conditions.

    Raises:
        BadData: It is another suite.
    """
    variation, path = read_variation(out), out / SUITE
    if variation is None or suite.name not in packaged_suites():
        check_name(suite, path)
    elif records:
        check_name(suite, path, partial(difference_under, records[0].conditions))
        known = {task.id: task for task in packaged_suite(suite.name).tasks}
        if digest_of_tasks([known[task.id] for task in suite.tasks]) != variation.base:
            reason = f"wasn't made from the packaged {suite.name}"
            raise BadData(out / VARIATION, reason, _REMEDY)


def _of_records(records: Sequence[EpisodeRecord], tasks: dict[str, Task]) -> _Found:
    for line, record in enumerate(records, start=1):
        yield from ((line, reason) for reason in amiss_beside_task(record, tasks[record.task]))
        yield from ((line, reason) for reason in amiss_as_stated(record))
        form = _form_of(record, tasks[record.task])
        budget = budget_of(tasks[record.task])
        yield from ((line, reason) for reason in amiss_in_calls(record, form, budget))
        yield from ((line, reason) for reason in amiss_at_the_end(record))


def _form_of(record: EpisodeRecord, task: Task) -> AnswerForm:
    """What a record's tools took for a complete answer."""
    return ANY_ANSWER if record.tools < ANSWERS_CHECKED else answer_form(task)


def _circumstances(record: EpisodeRecord) -> object:
    """What all records of a folder have in common."""
    return record.noise, record.conditions, record.perception


def _of_folder(records: Sequence[EpisodeRecord], out: Path) -> _Found:
    """What doesn't agree with the folder's notes, or with the other records."""
    ordered, variation = read_ordered(out), read_variation(out)
    results = set[tuple[str, str, str, int]]()
    for line, record in enumerate(records, start=1):
        runs = ordered.get((record.agent, record.setting))
        if runs is not None and record.run >= runs:
            yield line, f"{runs} runs of each task were ordered, numbered from 0"
        if _circumstances(record) != _circumstances(records[0]):
            yield line, "its noise or its conditions aren't those of the first record"
        if record.tools != records[0].tools:
            yield line, "the version of its tools isn't that of the first record"
        if reason := _beside(record.conditions, variation):
            yield line, reason
        key = record.task, record.agent, record.setting, record.run
        if key in results:
            yield line, "the same run has a result above"
        if record.end != "fault":
            results.add(key)


def _beside(conditions: Conditions, variation: Variation | None) -> str | None:
    """In what conditions aren't those that the folder's tasks were made for."""
    if variation is None and changes_scenes(conditions):
        return f"it was run under {conditions.label}, and {VARIATION} is missing"
    if variation is not None and variation.conditions != conditions.label:
        return f"its conditions aren't those of {VARIATION}"
    return None


def _refuse(found: _Found, records: Sequence[EpisodeRecord], path: Path) -> None:
    every = list(found)
    if not every:
        return
    line, reason = every[0]
    record = records[line - 1]
    others = len({number for number, _ in every}) - 1
    more = f"; {others} more lines don't agree either" if others else ""
    whose = f"{record.task}, run {record.run} of {ascii(record.agent)[1:-1][:60]}"
    raise BadData(f"{path}, line {line}", f"{whose}: {reason}{more}", _REMEDY)
