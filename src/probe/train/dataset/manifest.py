"""What a data set for training holds, file by file, and whether it is still all there."""

from __future__ import annotations

import hashlib
from collections.abc import Collection, Mapping
from pathlib import Path
from typing import Literal

import pydantic

from probe.errors import BadData
from probe.files import read_document, write_text
from probe.reading import RECORDS, contents

MANIFEST = "manifest.json"
_REMEDY = "Write the data set again: probe dataset SELECTION OUT"


class FileMark(pydantic.BaseModel, extra="forbid", frozen=True):
    """A file's size and SHA-256."""

    size: int
    sha256: str


class Manifest(pydantic.BaseModel, extra="forbid", frozen=True):
    """What is in a data set.

    Attributes:
        points: How places are counted in its texts.
        side_px: Width and height of its pictures.
        examples: How many are told as they went (but see `find`), by type and setting.
        pictures: How many are shown in all, each as often as it is.
        objects: How many different ones are on its tables, by what they are for: "train",
            "evaluation", or "neither" (scans, a user's own); empty in older data sets.
        augmented: How many are told otherwise than they went, by way and type; none in most.
        not_augmented: How many couldn't be told so for sure, by way and reason.
        find: Whether what the teacher looked for by find_object is told.
        plain: Whether the teacher says each thing in one way alone.
        files: All others, by their path.
    """

    version: Literal[1] = 1
    points: str
    side_px: int
    examples: dict[str, dict[str, int]]
    pictures: int
    objects: dict[str, int] = {}
    augmented: dict[str, dict[str, int]] = {}
    not_augmented: dict[str, dict[str, int]] = {}
    find: bool = True
    plain: bool = False
    files: dict[str, FileMark]

    @property
    def total(self) -> int:
        """All examples that are told as they went."""
        return sum(sum(settings.values()) for settings in self.examples.values())


def augmented_told(manifest: Manifest) -> str:
    """A sentence on each way in which a data set's episodes are told again; empty without any."""
    told = list[str]()
    for way, by_type in manifest.augmented.items():
        left_out = manifest.not_augmented.get(way, {})
        why = "; ".join(f"{count}, as {reason}" for reason, count in sorted(left_out.items()))
        told.append(
            f"{sum(by_type.values())} examples more are {_WAYS.get(way, way)}; "
            f"{sum(left_out.values())} couldn't be told so{f' ({why})' if why else ''}."
        )
    return " ".join(told)


_WAYS = {
    "mirrored": "episodes of these, mirrored left to right",
    "wordings": "episodes of these, asked in other words",
    "phrases": "episodes of these, with other phrases of the teacher",
    "options": "episodes of these, with their options or marks under other letters",
    "names": "episodes of these, with other names of all things",
    "ids": "episodes of these, with other object_ids",
    "colours": "episodes of Compare, with other colours",
    "sizes": "episodes of Size, with other sizes of the marked things",
    "fewer": "episodes of these, with fewer things on the table",
    "refused": "episodes of these, with a call that is refused, as its object_id is out of date",
}


_WITHOUT_FINDING = (
    "Calls of find_object are left out, and the teacher's words with them are others: grasps and "
    "pushes take their object_ids from the lists. The tools' replies are as they were."
)
_PLAIN = "The teacher says each thing in one way alone."


def words_told(manifest: Manifest) -> str:
    """How a data set's teacher speaks otherwise than it did; empty if it doesn't."""
    told = [] if manifest.find else [_WITHOUT_FINDING]
    return " ".join([*told, _PLAIN] if manifest.plain else told)


def objects_told(objects: Mapping[str, int]) -> str:
    """A sentence or two on what the objects of a data set are for.

    Args:
        objects: As in a manifest.
    """
    if not objects:
        return "The data set doesn't say for what its objects are set aside."
    counts = {name: objects.get(name, 0) for name in ("train", "evaluation", "neither")}
    told = f"{counts['train']} objects are of the pool for training"
    if counts["neither"]:
        told += f", {counts['neither']} of no pool (scans, or somebody's own)"
    if not counts["evaluation"]:
        return f"{told}; none is set aside for evaluation."
    return (
        f"{told}, and **{counts['evaluation']} are set aside for evaluation**. A model that was "
        "trained on this has seen them, so nobody can claim that it meets unseen objects in suites."
    )


def mark_of(path: Path) -> FileMark:
    """A file's mark.

    Raises:
        BadData: It is missing or can't be read.
    """
    try:
        content = contents(path, 16 * RECORDS)
    except OSError as error:
        raise BadData(path, error.strerror or str(error), _REMEDY) from error
    return FileMark(size=len(content), sha256=hashlib.sha256(content).hexdigest())


def write_manifest(folder: Path, manifest: Manifest) -> None:
    """Write it into a data set.

    Raises:
        OutputFailed: It can't be written.
    """
    write_text(folder / MANIFEST, manifest.model_dump_json(indent=1) + "\n")


def check_dataset(folder: Path, types: Collection[str] = ()) -> Manifest:
    """See that a data set is whole before anything is trained on it.

    Args:
        folder: That `probe dataset` wrote.
        types: Of which there must be examples, besides those that the manifest names.

    Raises:
        BadData: A file is missing, cut off or changed, or a type is empty; it is named.
    """
    missing = f"It is no whole data set. {_REMEDY}"
    manifest = read_document(folder / MANIFEST, Manifest, _REMEDY, missing)
    for name, known in manifest.files.items():
        found = mark_of(folder / name)
        if found.size != known.size:
            reason = f"has {found.size} bytes, not {known.size}"
            raise BadData(folder / name, reason, _REMEDY)
        if found != known:
            raise BadData(folder / name, "has been changed", _REMEDY)
    for question_type in dict.fromkeys([*types, *manifest.examples]):
        if not sum(manifest.examples.get(question_type, {}).values()):
            remedy = "Collect and select some, or train without this type"
            raise BadData(folder / MANIFEST, f"there is no example of {question_type}", remedy)
    return manifest
