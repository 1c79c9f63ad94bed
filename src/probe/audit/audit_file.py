"""What replays of a folder's records came to, in a file beside them, bound to their bytes.

Whoever hands out a folder can write such a file, too. It counts only where its seal was made with
the key of whoever reads it.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import pydantic

from probe import __version__
from probe.audit.audit_key import is_sealed, key_of, ready_key, seal_of
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
        seal: Of all the others, with the key of whoever audited; None of before there were any.
    """

    version: Literal[1] = 1
    release: str
    suite: str
    records: str
    results: int = pydantic.Field(ge=0)
    verdicts: dict[str, ReplayVerdict]
    seal: str | None = None

    def sealed(self, key: bytes) -> AuditDocument:
        """The same with a seal."""
        return self.model_copy(update={"seal": seal_of(key, self._text)})

    def is_by(self, key: bytes | None) -> bool:
        """Whether it bears a seal of that key."""
        return self.seal is not None and is_sealed(key, self._text, self.seal)

    @property
    def _text(self) -> bytes:
        return self.model_dump_json(exclude={"seal"}).encode()


@dataclass(frozen=True)
class AuditProgress:
    """How far an audit of a folder has come.

    Attributes:
        results: Records that claim something.
        equal, differ, unable: Of these, how many were replayed to the same bytes, to others, or
            can't be replayed.
        stale: Whether suite, records or release have changed since; nothing is known then.
        elsewhere: Whether the file was made with another key, or with none; it counts for nothing.
    """

    results: int
    equal: int
    differ: int
    unable: int
    stale: bool = False
    elsewhere: bool = False

    @property
    def words(self) -> str:
        """What to say of the folder beside its scores."""
        if self.elsewhere:
            return f"not audited here ({AUDIT} was made elsewhere)"
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


def audit_of(out: Path, key_file: Path) -> AuditProgress:
    """How far the audit of a folder has come; what isn't about these very bytes doesn't count.

    Args:
        out: The folder.
        key_file: Of whoever asks; an audit with another key doesn't count either.

    Raises:
        BadData: The file of the audit is broken, or a file of the folder can't be read.
    """
    if not (out / AUDIT).exists():
        return NEVER
    known = _read(out)
    if not known.is_by(key_of(key_file)):
        return AuditProgress(known.results, 0, 0, 0, elsewhere=True)
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


def is_foreign(out: Path, key_file: Path) -> bool:
    """Whether a folder has an audit that wasn't made with this key.

    Raises:
        BadData: The file is broken.
    """
    return (out / AUDIT).exists() and not _read(out).is_by(key_of(key_file))


def earlier(out: Path, key_file: Path) -> dict[str, ReplayVerdict]:
    """Verdicts that still hold: of this key and release, about this suite and lines still there.

    What couldn't be replayed then may be today.

    Raises:
        BadData: The file is broken.
    """
    if not (out / AUDIT).exists() or is_foreign(out, key_file):
        return {}
    known, lines = _read(out), set(hashes_of_lines(out))
    if known.release != RELEASE or known.suite != _hashes(out)[0]:
        return {}
    return {
        line: verdict
        for line, verdict in known.verdicts.items()
        if line in lines and verdict.outcome != "not replayable"
    }


def keep(out: Path, verdicts: Mapping[str, ReplayVerdict], results: int, key_file: Path) -> None:
    """Write down what is known of a folder as it is now; the key is made if there is none yet.

    Raises:
        OutputFailed: It can't be written, or the key can't.
    """
    suite, records = _hashes(out)
    document = AuditDocument(
        release=RELEASE, suite=suite, records=records, results=results, verdicts=dict(verdicts)
    )
    sealed = document.sealed(ready_key(key_file))
    write_bytes(out / AUDIT, with_sum(sealed.model_dump_json(indent=1).encode()))


def hashes_of_lines(out: Path) -> list[str]:
    """SHA-256 of each line of a folder's records, without line ends.

    Raises:
        BadData: They can't be read.
    """
    return [hash_of_line(line) for line in lines_of(out / RECORDS)]


def hash_of_line(line: bytes) -> str:
    """SHA-256 of a record's line, without its end; hex digits."""
    return hashlib.sha256(line).hexdigest()


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
