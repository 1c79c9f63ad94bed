"""Which public files each scan of the catalogue is made of, from the package's data."""

from __future__ import annotations

from functools import cache
from importlib.resources import files
from typing import Annotated, Literal
from urllib.parse import quote

import yaml
from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, TypeAdapter

from probe.assets.pools.scan_catalogue import parsed_rows

FILES = "scan_files.csv"
SOURCES = "scan_sources.yaml"

ScanLayout = Literal["gso", "obj", "gltf"]


def _numbers(value: object) -> object:
    """Several numbers of a table's field, with `;` between them; an empty one is none."""
    return (value.split(";") if value else None) if isinstance(value, str) else value


class ScanSource(BaseModel):
    """A public collection of scans.

    Attributes:
        about: Whose it is.
        layout: How the files of an item lie, as the importers call it.
        files: Addresses by names; ``{item}`` stands for the item. A ZIP is unpacked.
        known: How far the addresses are certain.
    """

    model_config = ConfigDict(frozen=True, extra="forbid")

    about: str
    layout: ScanLayout
    files: dict[str, Annotated[str, Field(pattern=r"^https?://")]] = Field(min_length=1)
    known: str

    def urls_of(self, item: str) -> dict[str, str]:
        """The addresses of one item by names of files."""
        return {name: url.replace("{item}", quote(item)) for name, url in self.files.items()}


class ScanFile(BaseModel):
    """One scan: where it comes from, and what its file hashes to.

    Attributes:
        texture_px: Width and height of its texture.
        colour: What the whole texture is painted with, where the source has none.
        sha256: Of the file that `v1-scans` was made with.
    """

    model_config = ConfigDict(frozen=True, extra="forbid")

    id: str = Field(pattern=r"^[a-z0-9_]+$")
    source: str
    item: str = Field(pattern=r"^[A-Za-z0-9_]+$")
    licence: str = Field(min_length=1)
    source_dataset: str = Field(min_length=1)
    texture_px: Annotated[tuple[int, int], BeforeValidator(_numbers)]
    colour: Annotated[tuple[int, int, int] | None, BeforeValidator(_numbers)]
    sha256: str = Field(pattern=r"^[0-9a-f]{64}$")


@cache
def scan_files() -> tuple[ScanFile, ...]:
    """All confirmed scans of the catalogue, in its order."""
    text = (files("probe.assets") / "data" / FILES).read_text("utf-8")
    return tuple(parsed_rows(text, FILES, ScanFile))


@cache
def scan_collections() -> dict[str, ScanSource]:
    """The collections by name."""
    text = (files("probe.assets") / "data" / SOURCES).read_text("utf-8")
    return TypeAdapter(dict[str, ScanSource]).validate_python(yaml.safe_load(text))
