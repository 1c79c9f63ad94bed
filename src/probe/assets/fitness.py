"""Whether an object can stand on the table and be held by the gripper; if not, why."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from probe.assets.mesh.lattice import places, spots
from probe.assets.mesh.resting import STEADY_DEG, Rest
from probe.types import Array

LONGEST = 0.45
"""Metres; what is longer leaves no table for others (the catalogue's longest scan has 0.29)."""

SHORTEST = 0.015
"""Metres; a longest side below this is under 30 pixels long in the picture."""

OPENING = 0.128
"""Metres; the pads of our open 2F-140 are 128.5 mm apart."""

PAYLOAD = 2.5
"""Kilograms that a 2F-140 holds by friction, by its data sheet."""

_SPOTS = 800
_DENSE_SPOTS = 20_000
_THIN = 0.008
"""Metres; walls and rims thinner than this are looked for among the dense spots."""

_CONE_DEG = 20.0
"""Half angle within which a pad may press on a slant (friction 0.36); a wider cone would let it
pinch chords of what is too thick."""

_LEVEL = 0.7
"""A closing direction rising by less than this (45 degrees) can be had from above."""

_CLEAR = 0.01
"""Metres above the table that a finger needs beneath what it holds."""


def unfit(vertices: Array, faces: Array, rest: Rest | None, mass: float) -> str | None:
    """Why an object can't be used, or None if it can.

    Args:
        vertices: In its resting pose, metres, shape (n, 3).
        faces: Counter-clockwise from outside, shape (m, 3).
        rest: As `rest_of` found it.
        mass: Kilograms.
    """
    longest = float(np.ptp(vertices, axis=0).max())
    if longest > LONGEST:
        return f"is {100 * longest:.1f} cm long; the table takes {100 * LONGEST:.0f} cm"
    if longest < SHORTEST:
        return f"is {1000 * longest:.1f} mm long; below {1000 * SHORTEST:.0f} mm it can't be seen"
    if rest is None:
        return "is flat: without volume it can't lie on a table"
    if rest.tilt_deg < STEADY_DEG:
        return f"has no stable face: it rolls over at a tilt of {rest.tilt_deg:.1f} degrees"
    if mass > PAYLOAD:
        return f"weighs {mass:.2f} kg; the gripper holds {PAYLOAD} kg"
    if not holdable(vertices, faces):
        return f"can't be held: nothing of it is narrower than {1000 * OPENING:.0f} mm"
    return None


def holdable(vertices: Array, faces: Array, opening: float = OPENING) -> bool:
    """Whether the object as a whole, or some part of it, fits between the gripper's pads.

    As a whole: its width in some level direction. A part: two facing spots of the surface that
    press towards each other within a cone of 20 degrees, and lie on one level or 1 cm above
    the table. Walls, rims and handles count; the room that a hand needs there doesn't.

    Args:
        vertices: In the resting pose, metres, shape (n, 3).
        faces: Counter-clockwise from outside, shape (m, 3).
        opening: Metres.
    """
    turns = np.radians(np.arange(0, 180, 5))
    level = np.column_stack([np.cos(turns), np.sin(turns)])
    if np.ptp(vertices[:, :2] @ level.T, axis=0).min() <= opening:
        return True
    here, normals = _spots(vertices, faces, _SPOTS)
    pairs = np.column_stack(np.triu_indices(_SPOTS, 1))
    if _facing(here, normals, pairs, opening):
        return True
    here, normals = _spots(vertices, faces, _DENSE_SPOTS)
    thin = cKDTree(here).query_pairs(_THIN, output_type="ndarray")
    return _facing(here, normals, thin, opening)


def _facing(here: Array, normals: Array, pairs: Array, opening: float) -> bool:
    """Whether any of the pairs, shape (k, 2), of spots can be held between two pads."""
    first, second = pairs.T
    apart = here[second] - here[first]
    distance = np.linalg.norm(apart, axis=1)
    across = apart / np.maximum(distance, 1e-9)[:, None]
    straight = np.cos(np.radians(_CONE_DEG))
    facing = np.sum(normals[first] * across, axis=1) < -straight
    facing &= np.sum(normals[second] * across, axis=1) > straight
    reached = np.abs(across[:, 2]) < _LEVEL
    reached |= np.minimum(here[first, 2], here[second, 2]) > _CLEAR
    return bool((facing & reached & (distance <= opening)).any())


def _spots(vertices: Array, faces: Array, count: int) -> tuple[Array, Array]:
    """Places on the surface and the unit normals there, shape (count, 3) each."""
    face, weights = spots(vertices, faces, count)
    a, b, c = np.moveaxis(np.asarray(vertices, np.float64)[faces[face]], 1, 0)
    normals = np.cross(b - a, c - a)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    return places(vertices, faces, face, weights), normals
