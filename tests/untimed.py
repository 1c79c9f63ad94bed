"""Records as runs on different machines must agree on them: without times."""

from __future__ import annotations

from pathlib import Path

from probe.episodes.files import line_of, read_records
from probe.episodes.folder import RECORDS


def lines(folder: Path) -> list[bytes]:
    """A run's records without their times, in an order of their own.

    Failures of ours are left out: each stands beside its repetition.
    """
    records = [it for it in read_records(folder / RECORDS) if it.end != "fault"]
    return sorted(line_of(record, timed=False) for record in records)
