"""Which objects are for training and which for evaluation; near-duplicates stay together."""

from __future__ import annotations

import hashlib
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Annotated, Literal

import numpy as np
from pydantic import BaseModel, ConfigDict, Field
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components

from probe.assets.library import Library
from probe.assets.mesh.nearness import NearPair
from probe.assets.pools.division import Part
from probe.errors import BadData
from probe.files import read_document, write_text

EVALUATION_SHARE = 0.2


class Split(BaseModel):
    """Objects by id, each with its part."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    version: Literal[1] = 1
    evaluation_share: Annotated[float, Field(gt=0, lt=1)] = EVALUATION_SHARE
    parts: dict[str, Part]

    def ids(self, part: Part) -> list[str]:
        """Objects of a part, sorted."""
        return sorted(name for name, mine in self.parts.items() if mine == part)


class LeakingSplit(BadData):
    """Near-duplicates on both sides of a split."""


def split_objects(
    ids: Sequence[str], pairs: Sequence[NearPair], earlier: Split | None = None
) -> Split:
    """Give each group of near-duplicates to one part.

    What was assigned earlier stays; a new object joins its near-duplicates. A new group's part
    comes from a hash of its first id, so that adding objects moves no others.

    Args:
        ids: All objects.
        pairs: Near-duplicates among them.
        earlier: A split to keep to.

    Raises:
        LeakingSplit: Near-duplicates were assigned to different parts earlier.
    """
    kept = earlier or Split(parts={})
    check_split(kept, pairs)
    parts = dict(kept.parts)
    for group in groups_of(ids, pairs):
        known: set[Part] = {parts[name] for name in group if name in parts}
        if len(known) > 1:
            raise _leak(group, parts)
        part = known.pop() if known else _drawn(group[0], kept.evaluation_share)
        parts |= dict.fromkeys(group, part)
    return kept.model_copy(update={"parts": dict(sorted(parts.items()))})


def check_split(split: Split, pairs: Iterable[NearPair]) -> None:
    """Refuse a split that near-duplicates cross.

    Raises:
        LeakingSplit: Some do; the first is named.
    """
    parts = split.parts
    for pair in pairs:
        both = (parts.get(pair.one), parts.get(pair.other))
        if None not in both and both[0] != both[1]:
            raise _leak([pair.one, pair.other], parts)


def groups_of(ids: Sequence[str], pairs: Iterable[NearPair]) -> list[list[str]]:
    """Ids grouped by chains of near-duplicates, sorted."""
    ordered = sorted(ids)
    number = {name: place for place, name in enumerate(ordered)}
    links = [(number[pair.one], number[pair.other]) for pair in pairs]
    rows, columns = np.array(links, dtype=int).reshape(-1, 2).T
    shape = (len(ordered), len(ordered))
    matrix = coo_array((np.ones(len(links), bool), (rows, columns)), shape=shape)
    labels = connected_components(matrix, directed=False)[1]
    groups: dict[int, list[str]] = {}
    for name, label in zip(ordered, labels.tolist(), strict=True):
        groups.setdefault(label, []).append(name)
    return sorted(groups.values())


def part_of(library: Library, split: Split, part: Part) -> Library:
    """A library of the objects of one part alone."""
    ids = set(split.ids(part))
    return replace(library, specs=tuple(spec for spec in library.specs if spec.id in ids))


def write_split(path: Path, split: Split) -> None:
    """Store a split as JSON.

    Raises:
        OutputFailed: The disk is full, or the folder can't be written.
    """
    write_text(path, split.model_dump_json(indent=1) + "\n")


def read_split(path: Path) -> Split:
    """A split from its file.

    Raises:
        BadData: It can't be read or breaks the schema.
    """
    missing = "Make it with probe assets split."
    return read_document(path, Split, "Correct it or make it again.", missing)


def _drawn(first_id: str, share: float) -> Part:
    number = int.from_bytes(hashlib.sha256(f"split {first_id}".encode()).digest()[:8], "big")
    return "evaluation" if number / 2**64 < share else "train"


def _leak(group: Sequence[str], parts: Mapping[str, Part]) -> LeakingSplit:
    train = next(name for name in group if parts.get(name) == "train")
    other = next(name for name in group if parts.get(name) == "evaluation")
    reason = f"{train} is for training, but {other}, its near-duplicate, for evaluation"
    return LeakingSplit("split", reason, "Take one of them out of the split, or move it.")
