"""Model sets of the BOP benchmark: PLY in millimetres beside a ``models_info.json``."""

from __future__ import annotations

import csv
import re
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Annotated

import numpy as np
import trimesh
from pydantic import BaseModel, ConfigDict, Field, TypeAdapter, ValidationError

from probe.assets.importers.source import Importer, Source, SourceFacts, SourceFrame, Symmetries
from probe.assets.importers.stanford import ply_texture, read_ply
from probe.errors import BadData, BadMesh
from probe.files import fault
from probe.reading import json_contents

INFO = "models_info.json"
NAMES = "bop_names.csv"
MAX_INFO_BYTES = 16 * 2**20
MILLIMETRE = 0.001
_NUMBER = re.compile(r"obj_(\d{1,9})$")

Row = Annotated[list[float], Field(min_length=3, max_length=3)]
Matrix = Annotated[list[float], Field(min_length=16, max_length=16)]


class Turning(BaseModel):
    """A continuous symmetry: an axis and a point on it, millimetres."""

    axis: Row
    offset: Row


class Model(BaseModel):
    """What ``models_info.json`` says of one model, millimetres (BOP's dataset format)."""

    model_config = ConfigDict(frozen=True, extra="ignore", allow_inf_nan=False)

    size_x: float = Field(gt=0)
    size_y: float = Field(gt=0)
    size_z: float = Field(gt=0)
    symmetries_continuous: list[Turning] = []
    symmetries_discrete: list[Matrix] = []


_MODELS = TypeAdapter(dict[int, Model])


def _find(path: Path) -> list[Source]:
    """Every ``obj_*.ply`` beside a ``models_info.json`` below a folder, or in it."""
    folders = sorted(file.parent for file in path.rglob(INFO))
    found = [file for folder in folders for file in sorted(folder.glob("obj_*.ply"))]
    return [Source(str(file.relative_to(path)), file, file.parent) for file in found]


def read_models(path: Path) -> dict[int, Model]:
    """What a ``models_info.json`` says, by the models' numbers.

    Raises:
        BadData: It can't be read or breaks its schema.
    """
    try:
        if path.stat().st_size > MAX_INFO_BYTES:
            raise BadData(path, "is too large", "Download it again.")
        return _MODELS.validate_json(json_contents(path, MAX_INFO_BYTES))
    except OSError as error:
        raise BadData(path, error.strerror or "can't be read", "Download it again.") from error
    except ValidationError as error:
        raise BadData(path, fault(error, "the file"), "Download it again.") from error


def _facts(source: Source) -> SourceFacts:
    path = source.root / INFO
    number = _NUMBER.search(source.mesh.stem)
    models = read_models(path)
    if number is None or int(number.group(1)) not in models:
        raise BadMesh(source.mesh, f"{path.name} says nothing of it", "Download the set again.")
    model = models[int(number.group(1))]
    name = f"{_set_name(source.root)} {int(number.group(1))}"
    x, y, z = (MILLIMETRE * edge for edge in (model.size_x, model.size_y, model.size_z))
    words = _known_names().get(name)
    return SourceFacts(
        words or name,
        source=f"BOP, {name}",
        size=(x, y, z),
        symmetries=_symmetries(model),
        words=words or name,
    )


@cache
def _known_names() -> dict[str, str]:
    """What the models of well-known sets are, which their files don't say, by set and number."""
    text = (files("probe.assets") / "data" / NAMES).read_text("utf-8")
    rows = csv.DictReader(text.splitlines())
    return {f"{row['set']} {row['number']}": row["name"] for row in rows}


def _set_name(folder: Path) -> str:
    """Name of the data set that a folder of models belongs to: "ycbv" of ycbv/models."""
    home = folder.resolve()
    return home.parent.name if home.name.startswith("models") else home.name


def _symmetries(model: Model) -> Symmetries:
    axes = tuple(
        (np.array(turning.axis), MILLIMETRE * np.array(turning.offset))
        for turning in model.symmetries_continuous
    )
    poses = np.array(model.symmetries_discrete).reshape(-1, 4, 4)
    poses[:, :3, 3] *= MILLIMETRE
    return Symmetries(axes, tuple(poses))


def _files_of(source: Source) -> tuple[Path, ...]:
    return (source.mesh, ply_texture(source.mesh, source.root), source.root / INFO)


def _read(source: Source) -> trimesh.Trimesh:
    return read_ply(source.mesh, source.root)


BOP = Importer(_find, _facts, _files_of, _read, SourceFrame(MILLIMETRE, "z"))
