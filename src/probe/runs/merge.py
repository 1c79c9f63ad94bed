"""Joins folders of records about one suite, run under one set of conditions."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from probe.episodes.conventions import joined_conventions, write_conventions
from probe.episodes.files import write_records
from probe.episodes.folder import (
    RECORDS,
    SUITE,
    claim_setting,
    in_order,
    setting_of_folder,
    standing,
)
from probe.episodes.ordered import joined, write_ordered
from probe.episodes.participation import Points
from probe.episodes.record import EpisodeRecord
from probe.episodes.remarks import read_remarks, write_remarks
from probe.errors import BadData
from probe.runs.checks.folder import read_checked
from probe.runs.variation import read_variation, write_variation
from probe.tasks.suite import Suite
from probe.tasks.suite_file import read_suite, write_suite


def merge_folders(parts: Sequence[Path], out: Path) -> int:
    """Write the records of several folders into a new one, in order of tasks; returns how many.

    What people said of questions comes along; what they are in the middle of doesn't.

    Raises:
        BadData: They are about different suites, were run under different conditions, were to have
            different numbers of runs, a model counted or wrote places in two ways, their tools have
            different versions, a robot's pictures belong to one, only some are people's, an episode
            is in two of them, one can't be read or can't be of a run of the suite, or the new
            folder isn't new.
        OutputFailed: It can't be written.
    """
    if (out / SUITE).exists() or (out / RECORDS).exists():
        raise BadData(out, "holds a run", "Choose a new folder")
    suite = read_suite(parts[0] / SUITE)
    found: dict[tuple[str, str, str, int], Path] = {}
    points: dict[tuple[str, str], Points] = {}
    first: EpisodeRecord | None = None
    kept = list[EpisodeRecord]()
    for part in parts:
        _check_suite(part, suite)
        records = standing(in_order(read_checked(part, suite), suite))
        for record in records:
            first = first or record
            _check(part, record, first, found, points)
        kept += records
    setting, ordered, conventions = _setting(parts), joined(parts), joined_conventions(parts)
    remarks = [remark for part in parts for remark in read_remarks(part)]
    variation = read_variation(parts[0])
    if variation is not None:
        write_variation(out, variation)
    if setting is not None:
        claim_setting(out, setting)
    if ordered:
        write_ordered(out, ordered)
    if remarks:
        write_remarks(out, remarks)
    write_conventions(out, conventions)
    write_suite(out / SUITE, suite)
    write_records(out / RECORDS, in_order(kept, suite))
    return len(kept)


def _setting(parts: Sequence[Path]) -> str | None:
    """The setting that all folders claim for their records, if they do."""
    first, *others = (setting_of_folder(part) for part in parts)
    for part, setting in zip(parts[1:], others, strict=True):
        if setting != first:
            reason = f"is {_claim(setting)}, {parts[0]} {_claim(first)}"
            raise BadData(part, reason, "Merge people's folders with people's alone")
    return first


def _claim(setting: str | None) -> str:
    return "of agents" if setting is None else f"of the setting {setting}"


def _check_suite(part: Path, suite: Suite) -> None:
    if read_suite(part / SUITE) != suite:
        raise BadData(part / SUITE, "is another suite", "Merge runs of one suite")


def _check(
    part: Path,
    record: EpisodeRecord,
    first: EpisodeRecord,
    found: dict[tuple[str, str, str, int], Path],
    points: dict[tuple[str, str], Points],
) -> None:
    """Refuse a record that doesn't go with those before it; note it otherwise."""
    if (record.noise, record.conditions) != (first.noise, first.conditions):
        raise BadData(part, "was run under other conditions", "Merge runs under the same ones")
    if record.perception != first.perception:
        raise BadData(part, "was run with another perception", "Merge runs with the same one")
    seat = record.participation
    whose = record.agent, record.setting
    if seat and points.setdefault(whose, seat.points) != seat.points:
        raise BadData(part, "was run with other --points", "Merge runs with the same ones")
    if record.frames:
        reason = "has pictures of a robot's table, which merging would leave behind"
        raise BadData(part, reason, "Name both folders to `probe report` instead")
    if record.tools != first.tools:
        reason = f"was run with version {record.tools} of the tools, others with {first.tools}"
        raise BadData(part, reason, "Merge runs of one version; `probe report` takes several")
    key = record.task, record.agent, record.setting, record.run
    if key in found:
        reason = f"{record.task}, {record.agent}, run {record.run} is in {found[key]} too"
        raise BadData(part, reason, "Leave one of the two out")
    found[key] = part
