"""One object as it lies in a data set: found, not yet read."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

import numpy as np
import trimesh

from probe.assets.importers.wording import speaking_root
from probe.types import Array

Format = Literal["gltf", "obj", "gso", "bop"]
Axis = Literal["y", "z"]

NO_LICENCE = "NOASSERTION"
"""SPDX's word for a licence that the source doesn't state."""


@dataclass(frozen=True)
class SourceFrame:
    """What a file's numbers mean.

    Attributes:
        unit: Metres per unit.
        up: The axis that points up; y up means x right and z towards the viewer, as in glTF.
    """

    unit: float = 1.0
    up: Axis = "z"

    @property
    def our_from_file(self) -> Array:
        """Rotation times metres per unit, shape (3, 3)."""
        turn = np.eye(3) if self.up == "z" else np.array([[1.0, 0, 0], [0, 0, -1.0], [0, 1.0, 0]])
        return self.unit * turn


@dataclass(frozen=True)
class Symmetries:
    """Motions that leave an object looking the same, in some frame, metres.

    Attributes:
        axes: Of continuous ones: direction and a point on it, each shape (3,).
        poses: Discrete ones, each shape (4, 4).
    """

    axes: tuple[tuple[Array, Array], ...] = ()
    poses: tuple[Array, ...] = ()


@dataclass(frozen=True)
class SourceFacts:
    """What a data set says of an object; None or empty where it says nothing.

    Attributes:
        name: In its own words ("Nintendo_Yoshi_Action_Figure").
        category: Common noun.
        mass: Kilograms.
        licence: SPDX identifier.
        source: Who made it, or which data set.
        size: Extent along the file's axes, in metres.
        symmetries: In the file's frame, lengths in metres.
        words: A short name for people, where one is known; else it is drafted from `name`.
        up: The upward axis that the object's folder speaks for.
        remarks: What a user should know of how it was read.
    """

    name: str
    category: str | None = None
    mass: float | None = None
    licence: str | None = None
    source: str | None = None
    size: tuple[float, float, float] | None = None
    symmetries: Symmetries = field(default_factory=Symmetries)
    words: str | None = None
    up: Axis | None = None
    remarks: tuple[str, ...] = ()


@dataclass(frozen=True)
class Source:
    """Where one object's files are.

    Attributes:
        label: Its place below what was asked for; for tables and messages.
        mesh: The file with its triangles.
        root: Nothing outside this folder is read, nor does a folder above it name the object.
    """

    label: str
    mesh: Path
    root: Path


@dataclass(frozen=True)
class Importer:
    """How one format is found and read.

    Attributes:
        find: Sources below a folder, or of one file, in a fixed order.
        facts: What the data set says of one. Raises BadMesh or BadData.
        files: All files that decide what it is, the mesh first. Raises BadMesh.
        read: Its triangles with texture, in the file's frame. Raises BadMesh.
        frame: Unit and axes, unless one says otherwise.
        tells_up: Whether the format states which axis points up; if not, the shape is asked.
    """

    find: Callable[[Path], list[Source]]
    facts: Callable[[Source], SourceFacts]
    files: Callable[[Source], tuple[Path, ...]]
    read: Callable[[Source], trimesh.Trimesh]
    frame: SourceFrame
    tells_up: bool = True


def sources_at(path: Path, *suffixes: str) -> list[Source]:
    """Files of these suffixes below a folder, sorted; or the one file itself."""
    root = speaking_root(path)
    if path.is_file():
        return [Source(path.name, path, root)]
    found = sorted(
        file
        for file in path.rglob("*")
        if file.suffix.lower() in suffixes
        and not any(part.startswith(".") for part in file.relative_to(path).parts)
    )
    return [Source(str(file.relative_to(path)), file, root) for file in found]
