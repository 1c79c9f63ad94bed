"""Lay an object of the library down again, with the other axis of its file up."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from probe.assets.fitness import unfit
from probe.assets.importers.entries import moved_symmetries, three
from probe.assets.importers.source import Axis, SourceFrame, Symmetries
from probe.assets.mesh.hollow import is_hollow
from probe.assets.mesh.mesh import TexturedMesh
from probe.assets.mesh.resting import rest_of
from probe.assets.mesh.shaping import centred
from probe.assets.mesh.squared import squaring_turn
from probe.assets.pools.entry import LibraryEntry
from probe.errors import BadData
from probe.types import Array, Pose, quaternion_of


def reposed(mesh: TexturedMesh, entry: LibraryEntry, up: Axis) -> tuple[TexturedMesh, LibraryEntry]:
    """An object as it would have been added with an axis of its file up, and its entry.

    Raises:
        BadData: It can't stand or be held like that.
    """
    before = Pose((0.0, 0.0, 0.0), entry.turn_wxyz).rotation
    vertices = mesh.vertices.astype(np.float64)
    read = vertices @ before @ SourceFrame(1.0, up).our_from_file.T
    rest = rest_of(read)
    turn = np.eye(3) if rest is None else rest.turn
    turn = squaring_turn(read @ turn.T) @ turn @ SourceFrame(1.0, up).our_from_file
    step = turn @ before.T
    placed = centred(vertices @ step.T, mesh.faces)
    reason = unfit(placed, mesh.faces, rest, entry.mass)
    if reason is not None:
        raise BadData(entry.id, f"with {up} up it {reason}", "Leave its axis as it is.")
    laid = replace(
        mesh,
        vertices=placed.astype(np.float32),
        normals=(mesh.normals @ step.T).astype(np.float32),
    )
    return laid, _entry(laid, entry, up, turn, step, placed[0] - step @ vertices[0])


def _entry(
    mesh: TexturedMesh, entry: LibraryEntry, up: Axis, turn: Array, step: Array, shift: Array
) -> LibraryEntry:
    moved = np.eye(4)
    moved[:3, :3], moved[:3, 3] = step, shift
    known = Symmetries(
        tuple((np.array(it.axis), np.array(it.offset)) for it in entry.symmetries_continuous),
        tuple(np.reshape(pose, (4, 4)) for pose in entry.symmetries_discrete),
    )
    axes, poses = moved_symmetries(known, moved)
    x, y, z = (round(float(edge), 4) for edge in mesh.extent)
    w, a, b, c = (float(value) for value in quaternion_of(turn))
    changes = {
        "size": (x, y, z),
        "hollow": is_hollow(mesh),
        "turn_wxyz": (w, a, b, c),
        "shift": three(step @ np.array(entry.shift) + shift),
        "symmetries_continuous": axes,
        "symmetries_discrete": poses,
        "up": up,
        "up_sure": True,
        "provenance": {**entry.provenance, "up": "human"},
    }
    return entry.model_copy(update=changes)
