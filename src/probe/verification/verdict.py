"""What became of a task's checks, in memory and on disk."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Annotated

import pydantic

from probe.files import read_document, write_text

CHECKS = ("text", "at rest", "hidden", "invariant", "unambiguous", "solvable")
"""In the order in which they are made."""


class TaskVerdict(
    pydantic.BaseModel, frozen=True, extra="forbid", validate_by_name=True, serialize_by_alias=True
):
    """The checks of one task.

    Attributes:
        task, question_type, digest: Which, and its hash then.
        problems: What is wrong, by check; a check that was made and found nothing has none.
        solved: Whether scripted agents were let try.
        outgrown: Whether none of them solved it, though with the tools that it was made with one
            did; that is no failure.
        histories: Random histories that were played.
        reachable: How many of them left the deciding evidence within reach.
        observed: Whether the observer, who only looks, was right; None where a check failed.
    """

    task: str
    question_type: Annotated[str, pydantic.Field(alias="kind")]
    digest: str
    problems: Mapping[str, tuple[str, ...]]
    solved: bool = False
    outgrown: bool = False
    histories: int = 0
    reachable: int = 0
    observed: bool | None = None

    @property
    def holds(self) -> bool:
        """Whether every check that was made passed."""
        return not any(self.problems.values())


def write_verdict(path: Path, verdict: TaskVerdict) -> None:
    """Write a verdict as JSON; whole or not at all."""
    write_text(path, verdict.model_dump_json(indent=1) + "\n")


def read_verdict(path: Path) -> TaskVerdict:
    """Read a verdict.

    Raises:
        BadData: The file is missing, truncated or something else.
    """
    return read_document(path, TaskVerdict, "Delete it; its task is then verified anew")
