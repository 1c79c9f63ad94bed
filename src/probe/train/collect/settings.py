"""What all episodes of a collection have in common, in a file that says so."""

from __future__ import annotations

from pathlib import Path

import pydantic

from probe.files import claim_folder, read_document

SETTINGS = "collection.json"
_REMEDY = "Collect into another folder"


class CollectionSettings(pydantic.BaseModel, extra="forbid", frozen=True):
    """How a collection is made.

    Attributes:
        agent: Who teaches.
        pool: Which objects appear.
        split: Of which split the training part is taken, by the hash of its file; None for all.
        points: How places are counted in pictures.
        graphs: How lists are told to a model that sees no pictures.
        noise: How far the hand errs, by name.
        lighting: Of the pictures.
        renderer: What draws them.
        shard: Which part of the tasks, such as "0/2".
        first: Number of the first episode of all shards.
        tools: Version of the tools; 1 in files of before it was written down.
    """

    version: int = 2
    agent: str
    pool: str
    split: str | None
    points: str
    graphs: str = pydantic.Field(default="full", exclude_if=lambda it: it == "full")
    noise: str
    lighting: str
    # Left out where it is the usual one, as files of before there was a choice do.
    renderer: str = pydantic.Field(default="own", exclude_if=lambda it: it == "own")
    shard: str
    first: int
    tools: int = 1


def claim(out: Path, settings: CollectionSettings) -> None:
    """Begin a collection, or see that it was begun in this way.

    Raises:
        BadData: It was begun otherwise.
        OutputFailed: It can't be written.
    """
    claim_folder(out / SETTINGS, settings, _REMEDY)


def read_settings(out: Path) -> CollectionSettings:
    """How a collection was begun.

    Raises:
        BadData: It is none, or the file is broken.
    """
    return read_document(out / SETTINGS, CollectionSettings, _REMEDY)
