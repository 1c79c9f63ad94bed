"""What replays of a folder's records came to, in a file beside them, bound to their bytes."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import pydantic

from probe import __version__
from probe.checksum import with_sum
from probe.episodes.files import lines_of
from probe.episodes.folder import RECORDS, SUITE
from probe.errors import BadData
from probe.files import read_document, write_bytes

AUDIT = "audit.json"
RELEASE = __version__
"""Of PROBE; another one's tools may tell the same in other words."""

Outcome = Literal["equal", "differs", "not replayable"]


class ReplayVerdict(pydantic.BaseModel, extra="forbid", frozen=True):
    """What came of replaying one record.

    Attributes:
        outcome: Whether the same bytes came out.
        reason: Where they differ, or why it can't be replayed.
    """

    outcome: Outcome
    reason: str = ""


class AuditDocument(pydantic.BaseModel, extra="forbid", frozen=True):
    """The file.

    Attributes:
        release: Of PROBE, that did the calls again.
        suite, records: SHA-256 of the two files as they were.
        results: How many records there were but for failures of ours, which claim nothing.
        verdicts: By SHA-256 of a record's line.
    """

    version: Literal[1] = 1
    release: str
    suite: str
    records: str
    results: int = pydantic.Field(ge=0)
    verdicts: dict[str, ReplayVerdict]


@dataclass(frozen=True)
class AuditProgress:
    """How far an audit of a folder has come.

    Attributes:
        results: Records that claim something.
        equal, differ, unable: Of these, how many were replayed to the same bytes, to others, or
            can't be replayed.
        stale: Whether suite, records or release have changed since; nothing is known then.
    """

    results: int
    equal: int
    differ: int
    unable: int
    stale: bool = False

    @property
    def words(self) -> str:
        """What to say of the folder beside its scores."""
        if self.stale:
            return "not audited: records, suite or PROBE's release have changed since it was"
        replayed = self.equal + self.differ
        if not replayed:
            return "not audited" + self._unable
        said = f"audited: {replayed} of {self.results} replayed"
        if self.differ:
            return f"{said}, {self.differ} DIFFER from what is recorded{self._unable}"
        return f"{said}, all equal{self._unable}"

    @property
    def _unable(self) -> str:
        return f"; {self.unable} of {self.results} can't be replayed" if self.unable else ""


NEVER = AuditProgress(0, 0, 0, 0)
"""Of a folder that nobody has audited."""


def audit_of(out: Path) -> AuditProgress:
    """How far the audit of a folder has come; what isn't about these very bytes doesn't count.

    Raises:
        BadData: The file of the audit is broken, or a file of the folder can't be read.
    """
    if not (out / AUDIT).exists():
        return NEVER
    known = _read(out)
    if known.release != RELEASE or (known.suite, known.records) != _hashes(out):
        return AuditProgress(known.results, 0, 0, 0, stale=True)
    return counted(known.verdicts, known.results)


def counted(verdicts: Mapping[str, ReplayVerdict], results: int) -> AuditProgress:
    """How many of which outcome."""
    outcomes = [verdict.outcome for verdict in verdicts.values()]
    return AuditProgress(
        results,
        equal=outcomes.count("equal"),
        differ=outcomes.count("differs"),
        unable=outcomes.count("not replayable"),
    )


def earlier(out: Path) -> dict[str, ReplayVerdict]:
    """Verdicts that still hold: by this release, about this suite and lines that are still there.

    What couldn't be replayed then may be today.

    Raises:
        BadData: The file is broken.
    """
    if not (out / AUDIT).exists():
        return {}
    known, lines = _read(out), set(hashes_of_lines(out))
    if known.release != RELEASE or known.suite != _hashes(out)[0]:
        return {}
    return {
        line: verdict
        for line, verdict in known.verdicts.items()
        if line in lines and verdict.outcome != "not replayable"
    }


def keep(out: Path, verdicts: Mapping[str, ReplayVerdict], results: int) -> None:
    """Write down what is known of a folder as it is now.

    Raises:
        OutputFailed: It can't be written.
    """
    suite, records = _hashes(out)
    document = AuditDocument(
        release=RELEASE, suite=suite, records=records, results=results, verdicts=dict(verdicts)
    )
    write_bytes(out / AUDIT, with_sum(document.model_dump_json(indent=1).encode()))


def hashes_of_lines(out: Path) -> list[str]:
    """SHA-256 of each line of a folder's records, without line ends.

    Raises:
        BadData: They can't be read.
    """
    return [hashlib.sha256(line).hexdigest() for line in lines_of(out / RECORDS)]


def hash_of(path: Path) -> str:
    """SHA-256 of a file.

    Raises:
        BadData: It can't be read.
    """
    try:
        with path.open("rb") as file:
            return hashlib.file_digest(file, "sha256").hexdigest()
    except OSError as error:
        raise BadData(path, error.strerror or str(error), "Check the path") from error


def _hashes(out: Path) -> tuple[str, str]:
    return hash_of(out / SUITE), hash_of(out / RECORDS)


def _read(out: Path) -> AuditDocument:
    return read_document(out / AUDIT, AuditDocument, "Delete it and audit the folder again")
