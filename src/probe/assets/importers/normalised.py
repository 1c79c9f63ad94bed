"""From a source to an object of the library: scaled, upright, lying, described; or refused."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

import numpy as np
import trimesh

from probe.assets.cache import content_key
from probe.assets.fitness import unfit
from probe.assets.importers import IMPORTERS
from probe.assets.importers.density import typical_mass
from probe.assets.importers.entries import entry_of, words_of
from probe.assets.importers.options import ImportOptions
from probe.assets.importers.source import Source, SourceFacts, SourceFrame
from probe.assets.importers.upright import Reading, likely_up, other_axis
from probe.assets.mesh.mesh import TexturedMesh
from probe.assets.mesh.resting import Rest, rest_of
from probe.assets.mesh.shaping import LARGEST, SMALLEST, check_geometry, placed, textured
from probe.assets.mesh.squared import squaring_turn
from probe.assets.mesh.wholeness import broken_parts
from probe.assets.pools.entry import LibraryEntry
from probe.errors import BadMesh
from probe.reading import MESH, contents
from probe.types import Array

UNITS = {"m": (1.0, "metres"), "cm": (0.01, "centimetres"), "mm": (0.001, "millimetres")}
SHORT, LONG = 0.015, 0.45
"""Longest sides, metres, of what is at home on a table."""


def check_unit(path: Path, longest: float, unit: float) -> None:
    """Refuse what is absurdly large or small in its unit if another one would fit.

    Args:
        path: For the message.
        longest: Of the sides along the file's axes, in the file's numbers.
        unit: Metres per unit, as the file is read.

    Raises:
        BadMesh: It is over 2 m or under 5 mm long, and would be 1.5 to 45 cm in another unit.
    """
    if SMALLEST <= longest * unit <= LARGEST:
        return
    fitting = {
        name: (metres * longest, word)
        for name, (metres, word) in UNITS.items()
        if SHORT <= metres * longest <= LONG
    }
    if not fitting:
        return
    size = longest * unit
    told = f"{size:.3g} m" if size >= 1 else f"{1000 * size:.3g} mm"
    taken = next((word for metres, word in UNITS.values() if metres == unit), f"units of {unit} m")
    meant = " or ".join(word for _, word in fitting.values())
    reason = f"its longest side is {told}. It looks like {meant} taken for {taken}"
    ways = " or ".join(
        f"--unit {name} ({100 * side:.3g} cm)" for name, (side, _) in fitting.items()
    )
    raise BadMesh(path, reason, f"Say {ways}.")


IMPORT_VERSION = 1
"""To be raised when the same files give another object: what was added before isn't skipped."""

SIZE_TOLERANCE = 0.02
"""Share of the longest side by which a file may differ from what its data set says."""


def content_of(source: Source, order: ImportOptions) -> str:
    """Hash of a source's files and of how they are read.

    Raises:
        BadMesh: A file is missing, or refers outside its folder.
    """
    files = IMPORTERS[order.format].files(source)
    try:
        parts = [contents(file, MESH) for file in files]
    except OSError as error:
        reason = error.strerror or "can't be read"
        raise BadMesh(source.mesh, reason, "Check the path and its permissions.") from error
    return content_key(f"{IMPORT_VERSION} {order.key}", *parts)


def normalised(source: Source, order: ImportOptions) -> tuple[TexturedMesh, LibraryEntry]:
    """The object of a source, in its resting pose, and its entry (id without a suffix yet).

    Raises:
        BadMesh: The files can't be used, or the object can't stand on a table or be held.
        BadData: What the data set says of it is broken.
    """
    importer = IMPORTERS[order.format]
    facts = importer.facts(source)
    facts = replace(
        facts, licence=facts.licence or order.licence, source=facts.source or order.source
    )
    part = importer.read(source)
    used = _used(source, part)
    check_unit(source.mesh, float(np.ptp(used, axis=0).max()), order.frame.unit)
    reading = _reading(used, order, facts)
    frame = SourceFrame(order.frame.unit, reading.up)
    vertices, faces = placed(source.mesh, part, frame.our_from_file)
    _check_stated_size(source, facts, vertices[np.unique(faces)], frame)
    rest = rest_of(vertices[np.unique(faces)])
    our_from_file = _lying(rest, vertices) @ frame.our_from_file
    mesh = textured(source.mesh, part, our_from_file)
    mass = facts.mass or typical_mass(mesh.vertices.astype(np.float64), _words(facts))
    reason = unfit(mesh.vertices, mesh.faces, rest, mass)
    if reason is not None:
        raise BadMesh(source.mesh, reason, _remedy(reading))
    broken = broken_parts(mesh)
    facts = replace(facts, remarks=(*facts.remarks, *((broken,) if broken else ())))
    moved = placed(source.mesh, part, our_from_file)[0][0] - our_from_file @ part.vertices[0]
    our_from_metres = np.eye(4)
    our_from_metres[:3, :3], our_from_metres[:3, 3] = our_from_file / frame.unit, moved
    content = content_of(source, order)
    entry = entry_of(source, order, facts, mesh, mass, our_from_metres, content, reading)
    return mesh, entry


def _reading(points: Array, order: ImportOptions, facts: SourceFacts) -> Reading:
    """Which axis points up: as ordered, as the format or the folder says, or as the shape does."""
    if order.up is not None or IMPORTERS[order.format].tells_up:
        return Reading(order.frame.up, True)
    if facts.up is not None:
        return Reading(facts.up, True)
    return likely_up(points * order.frame.unit, order.frame.up)


def _lying(rest: Rest | None, vertices: Array) -> Array:
    """The turn, shape (3, 3), that lays an object down with its box along the axes."""
    turn = np.eye(3) if rest is None else rest.turn
    return squaring_turn(vertices @ turn.T) @ turn


def _used(source: Source, part: trimesh.Trimesh) -> Array:
    """The vertices that faces use, checked, as they stand in the file, shape (n, 3)."""
    vertices, faces = np.asarray(part.vertices, np.float64), np.asarray(part.faces, np.int64)
    check_geometry(source.mesh, vertices, faces)
    return vertices[np.unique(faces)]


def _words(facts: SourceFacts) -> str:
    """What says most of what it is made of: the name, and the category where it is known."""
    return " ".join(filter(None, (words_of(facts), facts.category)))


def _remedy(reading: Reading) -> str:
    if reading.sure:
        return "Leave it out."
    return f"Say --up {other_axis(reading.up)} if that axis points up in the file; or leave it out."


def _check_stated_size(
    source: Source, facts: SourceFacts, vertices: Array, frame: SourceFrame
) -> None:
    if facts.size is None or frame.up != "z":
        return
    measured = np.ptp(vertices, axis=0)
    off = np.abs(measured - facts.size).max()
    if off > SIZE_TOLERANCE * max(facts.size) + 0.001:
        found, stated = _centimetres(measured), _centimetres(facts.size)
        reason = f"measures {found}, but its data set says {stated}"
        raise BadMesh(source.mesh, reason, "Check the unit of length.")


def _centimetres(size: Iterable[float]) -> str:
    return " x ".join(f"{100 * edge:.1f}" for edge in size) + " cm"
