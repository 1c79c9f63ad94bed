"""What a library writes down of an imported object: stated, measured or estimated."""

from __future__ import annotations

import re

import numpy as np

from probe.assets.colours import main_colours
from probe.assets.entry import Entry, Provenance, TurningSymmetry
from probe.assets.hollow import is_hollow
from probe.assets.hulls import hull_volume
from probe.assets.importers.order import Order
from probe.assets.importers.source import NO_LICENCE, Facts, Source, Symmetries
from probe.assets.mesh import TexturedMesh
from probe.assets.sampling import colours_at, spots
from probe.types import Array, Vector3, quaternion_of

FRICTION = 0.5
DENSITY = 250.0
"""Kilograms by cubic metre of hull: household things are mostly hollow or packed loosely."""

LIGHTEST, HEAVIEST_GUESS = 0.01, 5.0
COLOUR_SPOTS = 4000
LONGEST_SLUG = 40


def guessed_mass(mesh: TexturedMesh) -> float:
    """Kilograms, from the hull's volume at 250 kg by cubic metre."""
    guess = DENSITY * hull_volume(mesh.vertices.astype(np.float64))
    return round(min(max(guess, LIGHTEST), HEAVIEST_GUESS), 3)


def slug(name: str) -> str:
    """An id for the library from a data set's name for an object."""
    words = re.sub(r"[^a-z0-9]+", "_", name.lower()).strip("_")
    if len(words) > LONGEST_SLUG:
        words = words[: LONGEST_SLUG + 1].rpartition("_")[0] or words[:LONGEST_SLUG]
    return "own_" + (words or "object")


def entry_of(
    source: Source,
    order: Order,
    facts: Facts,
    mesh: TexturedMesh,
    mass: float,
    our_from_metres: Array,
    content: str,
) -> Entry:
    """The entry of an object, its id without a suffix yet.

    Args:
        source: Where it was found.
        order: How it is added.
        facts: What its data set says, the order's own words filled in.
        mesh: In its resting pose.
        mass: Kilograms.
        our_from_metres: From the file's axes, in metres, to ours, shape (4, 4).
        content: Hash of its files.
    """
    name = re.sub(r"[^a-z0-9]+", " ", facts.name.lower()).strip() or "object"
    x, y, z = (round(float(edge), 4) for edge in mesh.extent)
    w, a, b, c = (float(v) for v in quaternion_of(our_from_metres[:3, :3]))
    axes, poses = _moved(facts.symmetries, our_from_metres)
    return Entry(
        id=slug(facts.name),
        name=name,
        category=facts.category or name,
        colours=main_colours(colours_at(mesh, *spots(mesh.vertices, mesh.faces, COLOUR_SPOTS))),
        description=f"A {name}.",
        mass=round(mass, 4),
        friction=FRICTION,
        size=(x, y, z),
        hollow=is_hollow(mesh),
        licence=facts.licence or NO_LICENCE,
        source=facts.source or source.label,
        provenance=_provenance(facts),
        format=order.format,
        file=source.label,
        content=content,
        unit=order.frame.unit,
        turn_wxyz=(w, a, b, c),
        shift=_three(our_from_metres[:3, 3]),
        symmetries_continuous=axes,
        symmetries_discrete=poses,
    )


def _provenance(facts: Facts) -> dict[str, Provenance]:
    return {
        "name": "source",
        "category": "source" if facts.category else "estimated",
        "colours": "measured",
        "description": "estimated",
        "mass": "source" if facts.mass else "estimated",
        "friction": "estimated",
        "size": "measured",
        "hollow": "measured",
    }


def _moved(
    symmetries: Symmetries, our_from_metres: Array
) -> tuple[tuple[TurningSymmetry, ...], tuple[tuple[float, ...], ...]]:
    """Symmetries of the file's frame as those of ours."""
    rotation, shift = our_from_metres[:3, :3], our_from_metres[:3, 3]
    axes = tuple(
        TurningSymmetry(axis=_three(rotation @ axis), offset=_three(rotation @ point + shift))
        for axis, point in symmetries.axes
    )
    back = np.linalg.inv(our_from_metres)
    poses = [our_from_metres @ pose @ back for pose in symmetries.poses]
    return axes, tuple(tuple(float(v) for v in pose.reshape(-1)) for pose in poses)


def _three(vector: Array) -> Vector3:
    x, y, z = (float(v) for v in vector)
    return (x, y, z)
