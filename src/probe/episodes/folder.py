"""A folder of records and the suite that they are about, for one process or several."""

from __future__ import annotations

import fcntl
from collections.abc import Generator, Iterable
from contextlib import contextmanager
from pathlib import Path

from probe.episodes.files import append_line, read_records
from probe.episodes.record import EpisodeRecord
from probe.errors import BadData
from probe.files import alone, write_text
from probe.reading import is_there, opened, words
from probe.tasks.suite import Suite
from probe.tasks.suite_file import read_suite, write_suite
from probe.toolshed.version import TOOLS_VERSION, release_words

RECORDS, SUITE, SETTING = "records.jsonl", "suite.json", "arm"


def start_folder(out: Path, suite: Suite) -> None:
    """Make a folder that agents' records about a suite can be added to, or see that it is one.

    Raises:
        BadData: It is about another suite, is kept for people's records, or its records can't be
            read or were made by tools of another version.
        OutputFailed: It can't be written.
    """
    check_suite(out, suite)
    check_for_agents(out)
    if (out / RECORDS).exists():
        check_tools_of(out / RECORDS, read_records(out / RECORDS))
    _found(out, suite)


def _found(out: Path, suite: Suite) -> None:
    """Write the suite if there is none: one for all, as a run's lock lies on this very file."""
    if (out / SUITE).exists():
        return
    with alone(out):
        if not (out / SUITE).exists():
            write_suite(out / SUITE, suite)
    check_suite(out, suite)


@contextmanager
def occupied(out: Path, suite: Suite) -> Generator[None]:
    """Make or take up a folder, which check_suite has seen, and keep other runs out of it.

    Raises:
        BadData: Another run is at work there.
        OutputFailed: It can't be written.
    """
    _found(out, suite)
    with reserved(out):
        yield


def check_suite(out: Path, suite: Suite) -> None:
    """See that a folder, if it is one, is about a suite.

    Raises:
        BadData: It is about another one.
    """
    if not (out / SUITE).exists():
        return
    found = read_suite(out / SUITE)
    if found == suite:
        return
    reason = "is another suite"
    if found.name == suite.name and len(found.tasks) != len(suite.tasks):
        reason = (
            f"is another suite: {len(found.tasks)} tasks of {found.name}, not {len(suite.tasks)}"
        )
    raise BadData(out / SUITE, reason, "Choose another folder")


def check_tools_of(path: Path, records: Iterable[EpisodeRecord]) -> None:
    """See that what is played now may stand beside records in a file.

    Raises:
        BadData: Tools of another version made one of them.
    """
    for record in records:
        if record.tools != TOOLS_VERSION:
            reason = (
                f"was run with version {record.tools} of the tools, and this release has version "
                f"{TOOLS_VERSION}"
            )
            remedy = f"Choose another folder, or go on with {release_words(record.tools)}"
            raise BadData(path, reason, remedy)


def claim_setting(out: Path, setting: str) -> None:
    """Say of a started folder that everybody whose record is in it answers in this setting.

    Raises:
        BadData: It holds records of another setting already.
        OutputFailed: It can't be written.
    """
    said = setting_of_folder(out)
    if said == setting:
        return
    if said is not None or (out / RECORDS).exists():
        reason = f"its records are of the setting {said}" if said else "others have records there"
        raise BadData(out, reason, "Choose another folder")
    write_text(out / SETTING, f"{setting}\n")


def check_for_agents(out: Path) -> None:
    """See that a folder doesn't claim one setting for all its records, as people's folders do.

    Raises:
        BadData: It does: an agent's record would count as a person's.
    """
    said = setting_of_folder(out)
    if said is not None:
        reason = f"is kept for records of the setting {said}"
        raise BadData(out, reason, "Choose another folder")


def setting_of_folder(out: Path) -> str | None:
    """The setting that a folder claims for all its records; None if each agent has its own.

    Raises:
        BadData: The file that says so can't be read.
    """
    path = out / SETTING
    if not is_there(path):
        return None
    try:
        return words(path).strip() or None
    except (OSError, UnicodeDecodeError) as error:
        raise BadData(path, str(error), "Write the setting's name into it") from error


def add_line(out: Path, line: bytes) -> None:
    """Add a record as it is written down, at its end.

    Raises:
        OutputFailed: It can't be written; nothing of it is left.
    """
    with alone(out):
        append_line(out / RECORDS, line)


def in_order(records: Iterable[EpisodeRecord], suite: Suite) -> list[EpisodeRecord]:
    """Records by task, agent, setting and run; faults before their repetition."""
    places = {task.id: place for place, task in enumerate(suite.tasks)}

    def place(record: EpisodeRecord) -> tuple[int, str, str, str, int, bool]:
        known = places.get(record.task, len(places))
        return known, record.task, record.agent, record.setting, record.run, record.end != "fault"

    return sorted(records, key=place)


def standing(records: Iterable[EpisodeRecord]) -> list[EpisodeRecord]:
    """Of records in order the last of each run: no faults that were made good since."""
    last = {(it.task, it.agent, it.setting, it.run): it for it in records}
    return list(last.values())


@contextmanager
def reserved(out: Path, name: str = SUITE) -> Generator[None]:
    """Keep other runs out of a started folder; the lock leaves no file and dies with us.

    Args:
        out: The folder.
        name: A file of it that each of them locks. Once it is there, nobody may replace it.

    Raises:
        BadData: Another run is at work there.
    """
    with opened(out / name) as file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError as error:
            remedy = "Wait for it, or choose another folder"
            raise BadData(out, "another run is at work there", remedy) from error
        yield
