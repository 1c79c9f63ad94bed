"""The log of a suite's building: candidates, what was kept, and which check rejected the rest."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

from probe.errors import BadData
from probe.generation.build_folder import KEPT, CandidateLog
from probe.reading import words

_REMEDY = "Take the log that `probe suite build` wrote beside the suite"


@dataclass(frozen=True)
class Candidates:
    """What became of the candidates of one question type.

    Attributes:
        solved, tried: First scripted attempts that succeeded, of all, before any was selected.
        seconds: Time that all of them took.
        rejected: Candidates by the check that they failed, most first.
    """

    question_type: str
    candidates: int
    kept: int
    solved: int
    tried: int
    seconds: float
    rejected: tuple[tuple[str, int], ...]


def read_build_log(path: Path) -> list[Candidates]:
    """Count a log's candidates, by type.

    Raises:
        BadData: It can't be read, is empty, or a line is none of a log.
    """
    try:
        texts = words(path).splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise BadData(path, str(error), _REMEDY) from error
    if not texts:
        raise BadData(path, "is empty", _REMEDY)
    return count_candidates(_line(path, *each) for each in enumerate(texts, start=1))


def _line(path: Path, number: int, text: str) -> CandidateLog:
    try:
        return CandidateLog.parse(text)
    except ValueError as error:
        raise BadData(f"{path}, line {number}", str(error), _REMEDY) from error


def count_candidates(lines: Iterable[CandidateLog]) -> list[Candidates]:
    """The same of lines that have been read."""
    question_types: dict[str, list[CandidateLog]] = {}
    for line in lines:
        question_types.setdefault(line.question_type, []).append(line)
    return [
        _count(question_type, question_types[question_type])
        for question_type in sorted(question_types)
    ]


def _count(question_type: str, lines: Sequence[CandidateLog]) -> Candidates:
    checks = Counter(line.check for line in lines)
    kept = checks.pop(KEPT, 0)
    tried = [line.solved for line in lines if line.solved is not None]
    return Candidates(
        question_type=question_type,
        candidates=len(lines),
        kept=kept,
        solved=sum(tried),
        tried=len(tried),
        seconds=sum(line.seconds for line in lines),
        rejected=tuple(checks.most_common()),
    )
