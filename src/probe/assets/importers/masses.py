"""What files beside a mesh say of its mass: URDF, SDF, MJCF, CSV. Knows no meshes."""

from __future__ import annotations

import csv
import io
import math
import re
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

from probe.assets.importers.mass_trees import TREES, masses_in_tree
from probe.errors import BadData

MAX_BYTES = 2**22
_MASS = re.compile(r"^(?:mass|weight)[\s_(\[]*(kg|g|kilograms?|grams?|grammes?)?[)\]]*$")
_NAMES = ("id", "name", "object", "object_id", "object_name", "model", "file", "mesh", "folder")
_REMEDY = "Name the column mass_kg or mass_g, one row an object"


def masses_in_table(path: Path, mesh: Path, home: Path) -> list[float]:
    """Kilograms in the rows of a table that name an object; empty if it has no column of masses.

    A row names an object by its folder, its file or its place (column ``id``, ``name``, ``object``,
    ``model``, ``file``, ``mesh`` or ``folder``). A table of one row in the object's folder is
    about it.

    Args:
        path: The table.
        mesh: Whose mass is asked for.
        home: The object's folder.

    Raises:
        BadData: It can't be read, its masses have no unit, or one is no number.
    """
    rows = _rows(path)
    if not rows:
        return []
    header = [name.strip().lower() for name in rows[0]]
    masses = [(at, found) for at, name in enumerate(header) if (found := _MASS.match(name))]
    if not masses:
        return []
    at, found = masses[0]
    if found.group(1) is None:
        raise BadData(path, f"its column {header[at]!r} states no unit", _REMEDY)
    scale = 1.0 if found.group(1).startswith("k") else 0.001
    keys = [number for number, name in enumerate(header) if name in _NAMES]
    about = [row for row in rows[1:] if _names_it(row, keys, path, mesh, home)]
    if not keys and len(rows) == 2 and path.parent == home:
        about = rows[1:]
    return [scale * _number(path, row[at]) for row in about if at < len(row) and row[at].strip()]


def _rows(path: Path) -> list[list[str]]:
    try:
        with path.open("rb") as file:
            raw = file.read(MAX_BYTES + 1)
        if len(raw) > MAX_BYTES:
            raise BadData(path, f"has over {MAX_BYTES // 2**20} MB", _REMEDY)
        lines = csv.reader(io.StringIO(raw.decode("utf-8-sig")))
        return [row for row in lines if any(cell.strip() for cell in row)]
    except (OSError, UnicodeDecodeError, csv.Error) as error:
        raise BadData(path, f"can't be read as a table ({error})", _REMEDY) from error


def _names_it(row: Sequence[str], keys: Sequence[int], path: Path, mesh: Path, home: Path) -> bool:
    places = (mesh, home)
    known = {_plain(place.name) for place in places} | {_plain(place.stem) for place in places}
    known |= {
        _plain(str(place.relative_to(path.parent))) for place in places if _below(place, path)
    }
    return any(at < len(row) and _plain(row[at]) in known for at in keys)


def _below(place: Path, path: Path) -> bool:
    return place.is_relative_to(path.parent)


def _plain(text: str) -> str:
    return re.sub(r"[^a-z0-9]+", "_", text.lower()).strip("_")


def _number(path: Path, text: str) -> float:
    try:
        return float(text)
    except ValueError as error:
        raise BadData(path, f"states a mass of {text[:40]!r}", _REMEDY) from error


_FOLDERS = ("", "urdf", "sdf", "mjcf")
_READERS: dict[str, Callable[[Path, Path, Path], list[float]]] = {
    **dict.fromkeys(TREES, masses_in_tree),
    ".csv": masses_in_table,
}


def stated_mass(mesh: Path, home: Path, root: Path) -> tuple[float | None, tuple[str, ...]]:
    """The mass of an object by the files beside it, the nearest first.

    Looked through are URDF, SDF and MJCF files in the object's folder (and its `urdf`, `sdf` and
    `mjcf`), then CSV tables there and in the folders above it.

    Args:
        mesh: The object's.
        home: The object's folder.
        root: The folder that was asked for; none above it is looked at.

    Returns:
        Kilograms, or None if nothing says; and, for the user, which files could not be used.
    """
    remarks: list[str] = []
    for path in _files(home, root):
        try:
            found = _READERS[path.suffix.lower()](path, mesh, home)
        except BadData as reason:
            remarks.append(f"no mass is read from {reason}")
            continue
        masses = [mass for mass in found if math.isfinite(mass) and mass > 0]
        if masses:
            return masses[0], tuple(remarks)
        if found:
            remarks.append(f"{path.name} states a mass of {found[0]:g} kg, which is not used")
    return None, tuple(remarks)


def _files(home: Path, root: Path) -> Iterator[Path]:
    for suffix in TREES:
        for folder in _FOLDERS:
            yield from _of_suffix(home / folder, suffix)
    for folder in (home, *home.parents):
        yield from _of_suffix(folder, ".csv")
        if folder == root or root not in folder.parents:
            break


def _of_suffix(folder: Path, suffix: str) -> list[Path]:
    if not folder.is_dir():
        return []
    return sorted(path for path in folder.iterdir() if path.suffix.lower() == suffix)
