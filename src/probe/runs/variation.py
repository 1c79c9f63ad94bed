"""What a folder's suite was varied from, and what is amiss with which task; a file beside it."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Sequence
from dataclasses import replace
from pathlib import Path

import pydantic

from probe.episodes.conditions import Conditions
from probe.episodes.folder import SUITE
from probe.errors import BadData
from probe.files import read_document, write_text
from probe.reading import is_there
from probe.runs.vary import VariedTask
from probe.tasks.suite import Suite
from probe.tasks.suite_file import digest_of, read_suite, write_suite
from probe.tasks.task import Task

VARIATION = "variation.json"


class Variation(pydantic.BaseModel, frozen=True, extra="forbid"):
    """How a folder's tasks came about.

    Attributes:
        base: Digest of the suite that was varied.
        conditions: In a few words.
        notes: What is amiss, by task.
    """

    base: str
    conditions: str
    notes: dict[str, str]


def read_variation(out: Path) -> Variation | None:
    """The variation of a folder; None if its tasks are as they were frozen.

    Raises:
        BadData: It can't be read.
    """
    path = out / VARIATION
    return read_document(path, Variation, "Choose another folder") if is_there(path) else None


def write_variation(out: Path, variation: Variation) -> None:
    """Write down how a folder's tasks came about.

    Raises:
        OutputFailed: It can't be written.
    """
    write_text(out / VARIATION, variation.model_dump_json(indent=1) + "\n")


def earlier(out: Path, base: Suite, conditions: Conditions) -> Suite | None:
    """The varied suite of a folder that was begun before; None if there is none yet.

    Raises:
        BadData: The folder is about another suite, or other conditions.
    """
    known = read_variation(out)
    if known is None and (out / SUITE).exists():
        raise BadData(out, "was run under other conditions", "Choose another folder")
    if known is None or not (out / SUITE).exists():
        return None
    if (known.base, known.conditions) != (digest_of_tasks(base.tasks), conditions.label):
        reason = f"is about another suite or other conditions ({known.conditions})"
        raise BadData(out, reason, "Choose another folder")
    return read_suite(out / SUITE)


def keep_varied(
    out: Path, base: Suite, conditions: Conditions, made: Sequence[VariedTask]
) -> Suite:
    """Write down tasks that were varied, and what is amiss with them.

    Raises:
        BadData: The folder was begun meanwhile.
        OutputFailed: They can't be written.
    """
    if (out / SUITE).exists():
        remedy = "Wait for it, or choose another folder"
        raise BadData(out, "another run has begun it meanwhile", remedy)
    suite = replace(base, tasks=tuple(each.task for each in made))
    notes = {each.task.id: each.note for each in made if each.note}
    known = Variation(base=digest_of_tasks(base.tasks), conditions=conditions.label, notes=notes)
    # A folder with a suite is a begun one: what says where that is from has to be there first.
    write_variation(out, known)
    write_suite(out / SUITE, suite)
    return suite


def digest_of_tasks(tasks: Iterable[Task]) -> str:
    """What a variation says of the tasks that it was made from."""
    lines = [f"{task.id} {digest_of(task)}" for task in tasks]
    return hashlib.sha256("\n".join(lines).encode()).hexdigest()
