"""A selection on disk: a suite, its records, and a document that says how they were chosen."""

from __future__ import annotations

import hashlib
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import pydantic

from probe import reading
from probe.assets.mesh.fingerprint import Fingerprint
from probe.episodes.files import read_records, write_records
from probe.episodes.folder import RECORDS, SUITE
from probe.episodes.record import EpisodeRecord
from probe.errors import BadData
from probe.files import check_new, read_document, whole_folder, write_text
from probe.runs.checks.folder import check_records
from probe.tasks.suite import Suite
from probe.tasks.suite_file import read_suite, write_suite
from probe.tasks.task import Task
from probe.train.choose.candidates import EpisodeCandidate
from probe.train.choose.evaluation import Leak
from probe.train.choose.selection import Recipe, Selection
from probe.transcripts.prompts import setting_named

SELECTION = "selection.json"
_REMEDY = "Select again: probe select FOLDER... --out OUT"


class Refused(pydantic.BaseModel, extra="forbid", frozen=True):
    """A task that belongs to evaluation."""

    task: str
    leak: Leak
    detail: str


class SelectionDocument(pydantic.BaseModel, extra="forbid", frozen=True):
    """How it was chosen.

    Attributes:
        files: SHA-256 of the files beside it.
        sources: Folders it was chosen from.
        suites: That nothing may be of.
        examples: How many, by type and setting.
        letters: How many by right answer.
        limits: The most manipulations that were let pass, by type.
        direct_share, slack, seed, least: The recipe's.
        dropped: Episodes that were left out, by reason.
        refused: Tasks that belong to evaluation.
    """

    version: Literal[1] = 1
    files: dict[str, str]
    sources: tuple[str, ...]
    suites: tuple[str, ...]
    examples: dict[str, dict[str, int]]
    letters: dict[str, int]
    limits: dict[str, int]
    direct_share: float
    slack: int
    least: int = 0
    seed: int
    dropped: dict[str, int]
    refused: tuple[Refused, ...]


@dataclass(frozen=True)
class LoadedSelection:
    """A selection that was read."""

    suite: Suite
    episodes: tuple[tuple[Task, EpisodeRecord], ...]
    document: SelectionDocument


def write_selection(
    out: Path,
    selection: Selection,
    recipe: Recipe,
    objects: Mapping[str, Fingerprint],
    sources: Sequence[Path],
    suites: Sequence[str],
) -> SelectionDocument:
    """Write a selection; the whole folder appears at once, or nothing does.

    Raises:
        BadData: The folder is there already.
        OutputFailed: It can't be written; nothing is left of it.
    """
    check_new(out)
    chosen = selection.chosen
    shown = {placed.object_id for it in chosen for placed in it.task.scene.objects}
    marks = {id: objects[id] for id in sorted(shown)}
    with whole_folder(out) as folder:
        write_suite(folder / SUITE, Suite("selection", tuple(it.task for it in chosen), marks))
        write_records(folder / RECORDS, [it.record for it in chosen])
        document = SelectionDocument(
            files={name: _hash(folder / name) for name in (SUITE, RECORDS)},
            sources=tuple(map(str, sources)),
            suites=tuple(suites),
            examples=counts_of(chosen),
            letters=dict(sorted(Counter(it.task.answer for it in chosen).items())),
            limits=dict(selection.limits),
            direct_share=recipe.direct_share,
            slack=recipe.slack,
            least=recipe.least,
            seed=recipe.seed,
            dropped=dict(selection.dropped),
            refused=tuple(Refused(**vars(it)) for it in selection.refused),
        )
        write_text(folder / SELECTION, document.model_dump_json(indent=1) + "\n")
    return document


def counts_of(chosen: Sequence[EpisodeCandidate]) -> dict[str, dict[str, int]]:
    """How many by type and setting."""
    counts: dict[str, dict[str, int]] = {}
    for it in chosen:
        settings = counts.setdefault(it.task.question_type, {"direct": 0, "agentic": 0})
        setting = setting_named(it.record.setting or "agentic")
        settings[setting] = settings.get(setting, 0) + 1
    return counts


def read_selection(folder: Path) -> LoadedSelection:
    """Read a selection.

    Raises:
        BadData: It isn't whole, something in it has changed since, or a record can't be of a run of
            its suite; the file is named.
    """
    document = read_document(folder / SELECTION, SelectionDocument, _REMEDY, _REMEDY)
    for name, known in document.files.items():
        if _hash(folder / name) != known:
            raise BadData(folder / name, "isn't what was selected: cut off or changed", _REMEDY)
    suite = read_suite(folder / SUITE)
    tasks = {task.id: task for task in suite.tasks}
    records = read_records(folder / RECORDS)
    check_records(records, suite, folder / RECORDS)
    empty = [
        question_type
        for question_type, settings in document.examples.items()
        if not sum(settings.values())
    ]
    if empty or not records:
        what = empty[0] if empty else "any type"
        raise BadData(folder / SELECTION, f"there is no example of {what}", _REMEDY)
    return LoadedSelection(suite, tuple((tasks[it.task], it) for it in records), document)


def _hash(path: Path) -> str:
    try:
        return hashlib.sha256(reading.contents(path, reading.RECORDS)).hexdigest()
    except OSError as error:
        raise BadData(path, error.strerror or str(error), _REMEDY) from error
