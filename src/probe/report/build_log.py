"""The log of a suite's building: candidates, what was kept, and which check rejected the rest."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

from probe.errors import BadData

KEPT = "kept"
_FIELDS = 5
_REMEDY = "Take the log.txt that `probe suite build` wrote"


@dataclass(frozen=True)
class Candidates:
    """What became of the candidates of one question type.

    Attributes:
        solved, tried: First scripted attempts that succeeded, of all, before any was selected.
        rejected: Candidates by the check that they failed, most first.
    """

    kind: str
    candidates: int
    kept: int
    solved: int
    tried: int
    rejected: tuple[tuple[str, int], ...]


def read_build_log(path: Path) -> list[Candidates]:
    """Count a log's candidates, by type.

    Raises:
        BadData: It can't be read, or a line isn't type, seed, check, solved and detail.
    """
    try:
        lines = path.read_text("utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise BadData(path, str(error), _REMEDY) from error
    for number, line in enumerate(lines, start=1):
        if line.count("\t") < _FIELDS - 1:
            raise BadData(f"{path}, line {number}", "has no five fields", _REMEDY)
    return count_candidates(lines)


def count_candidates(lines: Iterable[str]) -> list[Candidates]:
    """The same of lines that are in memory."""
    kinds: dict[str, list[list[str]]] = {}
    for line in lines:
        fields = line.split("\t", _FIELDS - 1)
        kinds.setdefault(fields[0], []).append(fields)
    return [_count(kind, kinds[kind]) for kind in sorted(kinds)]


def _count(kind: str, rows: list[list[str]]) -> Candidates:
    checks = Counter(row[2] for row in rows)
    kept = checks.pop(KEPT, 0)
    solved = [row[3] for row in rows]
    return Candidates(
        kind=kind,
        candidates=len(rows),
        kept=kept,
        solved=solved.count("True"),
        tried=len(rows) - solved.count("-"),
        rejected=tuple(checks.most_common()),
    )
