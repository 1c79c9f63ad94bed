"""What a user's library keeps of one object: its entry on disk. Knows no meshes."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field

from probe.assets.spec import ObjectSpec
from probe.files import read_document
from probe.types import Quaternion, Vector3

Provenance = Literal["source", "measured", "estimated", "model", "human"]
"""Where a field comes from: stated by the data set, measured on the mesh, guessed from its size,
written by a model, or by a person."""

Positive = Annotated[float, Field(gt=0)]
Matrix = Annotated[tuple[float, ...], Field(min_length=16, max_length=16)]


class TurningSymmetry(BaseModel):
    """An axis about which any turn leaves the object looking the same."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    axis: Vector3
    offset: Vector3
    """A point on it, metres."""


class LibraryEntry(BaseModel):
    """One object, as ``entry.json`` beside its ``object.glb``; lengths in metres.

    The GLB is in metres, lies in its resting pose and is centred; as in any glTF, y is up there.
    Symmetries are in our frame of it (z up).
    """

    model_config = ConfigDict(frozen=True, extra="forbid", allow_inf_nan=False)

    version: Literal[1] = 1
    id: str = Field(pattern=r"^own_[a-z0-9_]+$", max_length=80)
    name: str = Field(min_length=1)
    category: str = Field(min_length=1)
    colours: tuple[str, ...] = Field(min_length=1, max_length=3)
    description: str = Field(min_length=1)
    mass: float = Field(gt=0, le=5)
    friction: float = Field(ge=0.05, le=1.5)
    size: tuple[Positive, Positive, Positive]
    hollow: bool
    licence: str = Field(min_length=1)
    source: str = Field(min_length=1)
    provenance: dict[str, Provenance]
    format: str
    file: str
    """Its place in the folder it was added from."""

    content: str = Field(pattern=r"^[0-9a-f]{32}$")
    """Hash of the files it was made from, and of how they were read."""

    unit: Positive
    turn_wxyz: Quaternion
    """From the file's axes to ours, resting pose included."""

    shift: Vector3
    """Added after scaling and turning."""

    symmetries_continuous: tuple[TurningSymmetry, ...] = ()
    symmetries_discrete: tuple[Matrix, ...] = ()
    up: Literal["y", "z"] | None = None
    """The file's axis that was taken to point up; None in entries that don't say."""

    up_sure: bool = True
    """Whether the order, the format or the shape left no doubt of it."""

    remarks: tuple[str, ...] = ()
    """What the user should know of how it was read."""

    @property
    def spec(self) -> ObjectSpec:
        """What the catalogue says of it."""
        return ObjectSpec(
            id=self.id,
            name=self.name,
            category=self.category,
            colours=self.colours,
            description=self.description,
            mass=self.mass,
            friction=self.friction,
            size=self.size,
            hollow=self.hollow,
            origin="own",
            licence=self.licence,
            source=self.source,
        )


def read_entry(path: Path) -> LibraryEntry:
    """An entry from its file.

    Raises:
        BadData: It can't be read or breaks the schema.
    """
    remedy = "Correct it, or remove the object's folder and add the object again."
    return read_document(path, LibraryEntry, remedy, missing=remedy)
