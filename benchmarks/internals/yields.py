"""How many candidates become tasks, and which check rejects the others: from build logs.

Measures internals, not the public API.

`python benchmarks/internals/yields.py LOG...`; `probe suite build` writes a log beside every suite.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Annotated

import tyro

from probe.generation.build_folder import CandidateLog
from probe.report.build_log import count_candidates


def main(logs: Annotated[tuple[Path, ...], tyro.conf.Positional]) -> None:
    """Print a table.

    Args:
        logs: Of one or more builds.
    """
    lines = [CandidateLog.parse(line) for log in logs for line in log.read_text().splitlines()]
    print("\n".join(table(lines)))


def table(lines: list[CandidateLog]) -> Iterator[str]:
    """A row a type, in Markdown."""
    yield "| type | candidates | kept | s per kept task | first attempt solves | rejected by |"
    yield "|---|---|---|---|---|---|"
    for it in count_candidates(lines):
        rejected = ", ".join(f"{check} {count}" for check, count in it.rejected)
        kept = f"{it.kept} ({it.kept / it.candidates:.0%})"
        solved = f"{it.solved} of {it.tried}" if it.tried else ""
        each = f"{it.seconds / max(1, it.kept):.0f}"
        yield f"| {it.question_type} | {it.candidates} | {kept} | {each} | {solved} | {rejected} |"


if __name__ == "__main__":
    tyro.cli(main)
