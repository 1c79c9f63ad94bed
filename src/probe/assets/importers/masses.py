"""What files beside a mesh say of its mass: URDF, SDF, MJCF, CSV. Knows no meshes."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from pathlib import Path

from probe.assets.importers.mass_tables import masses_in_table
from probe.assets.importers.mass_trees import TREES, masses_in_tree
from probe.errors import BadData

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
