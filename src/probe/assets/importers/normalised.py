"""From a source to an object of the library: scaled, upright, lying, described; or refused."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from probe.assets.cache import content_key
from probe.assets.entry import Entry
from probe.assets.fitness import unfit
from probe.assets.importers import IMPORTERS
from probe.assets.importers.entries import entry_of, guessed_mass
from probe.assets.importers.order import Order
from probe.assets.importers.source import Facts, Frame, Source
from probe.assets.mesh import TexturedMesh
from probe.assets.resting import rest_of
from probe.assets.shaping import placed, textured
from probe.errors import BadMesh
from probe.reading import MESH, contents
from probe.types import Array

IMPORT_VERSION = 1
"""To be raised when the same files give another object: what was added before isn't skipped."""

SIZE_TOLERANCE = 0.02
"""Share of the longest side by which a file may differ from what its data set says."""


def content_of(source: Source, order: Order) -> str:
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
    return content_key(f"{IMPORT_VERSION} {order}", *parts)


def normalised(source: Source, order: Order) -> tuple[TexturedMesh, Entry]:
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
    frame = order.frame
    vertices, faces = placed(source.mesh, part, frame.our_from_file)
    _check_stated_size(source, facts, vertices[np.unique(faces)], frame)
    rest = rest_of(vertices[np.unique(faces)])
    turn = np.eye(3) if rest is None else rest.turn
    mesh = textured(source.mesh, part, turn @ frame.our_from_file)
    mass = facts.mass or guessed_mass(mesh)
    reason = unfit(mesh.vertices, mesh.faces, rest, mass)
    if reason is not None:
        raise BadMesh(source.mesh, reason, "Leave it out.")
    our_from_file = turn @ frame.our_from_file
    moved = placed(source.mesh, part, our_from_file)[0][0] - our_from_file @ part.vertices[0]
    our_from_metres = np.eye(4)
    our_from_metres[:3, :3], our_from_metres[:3, 3] = our_from_file / frame.unit, moved
    content = content_of(source, order)
    return mesh, entry_of(source, order, facts, mesh, mass, our_from_metres, content)


def _check_stated_size(source: Source, facts: Facts, vertices: Array, frame: Frame) -> None:
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
