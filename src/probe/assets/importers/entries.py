"""What a library writes down of an imported object: stated, measured or estimated."""

from __future__ import annotations

import re

import numpy as np

from probe.assets.colour.main_colours import said_colours
from probe.assets.importers.density import category_in
from probe.assets.importers.options import ImportOptions
from probe.assets.importers.source import NO_LICENCE, Source, SourceFacts, Symmetries
from probe.assets.importers.upright import Reading, up_doubt
from probe.assets.importers.wording import (
    LONGEST_NAME,
    all_words,
    colour_first,
    described,
    draft_name,
    id_words,
    shortened,
)
from probe.assets.mesh.hollow import is_hollow
from probe.assets.mesh.lattice import colours_at, spots
from probe.assets.mesh.mesh import TexturedMesh
from probe.assets.pools.entry import LibraryEntry, Provenance, TurningSymmetry
from probe.types import Array, Vector3, quaternion_of

FRICTION = 0.5
COLOUR_SPOTS = 4000


def object_id(name: str) -> str:
    """An id for the library from a data set's name for an object."""
    return f"own_{id_words(name)}"


def words_of(facts: SourceFacts) -> str:
    """The draft of a short name for people; if it is cut, what the thing is stays in."""
    if facts.words:
        return facts.words
    return colour_first(_short(facts), lambda words: category_in(words) is not None)


def _short(facts: SourceFacts) -> str:
    """The name as it stands in the files, in words, and short."""
    name, words = draft_name(facts.name), all_words(facts.name).split()
    noun = category_in(" ".join(words))
    if noun is None or category_in(name) == noun:
        return name
    while len(" ".join(words)) > LONGEST_NAME and len(words) > 1:
        words.pop(0)
    return shortened(" ".join(words), " ")


def category_of(facts: SourceFacts) -> str:
    """What the data set says, or the noun in the name; without numbers."""
    name = words_of(facts)
    said = _of_one(facts.category) if facts.category else category_in(name) or name
    letters = re.sub(r"[^a-z' -]+", " ", said.lower())
    return shortened(" ".join(letters.split()), " ") or "object"


def _of_one(category: str) -> str:
    """A category in the singular, if the table knows its noun: data sets say "Action Figures"."""
    noun = category_in(category)
    for ending in ("s", "es"):
        if noun and category.lower().endswith(f"{noun}{ending}"):
            return category[: -len(ending)]
    return category


def remarks_on(entry: LibraryEntry) -> tuple[str, ...]:
    """What a user should know of an object, a doubt about its upward axis first."""
    doubt = () if entry.up_sure or entry.up is None else (up_doubt(entry.up),)
    return (*doubt, *entry.remarks)


def entry_of(
    source: Source,
    order: ImportOptions,
    facts: SourceFacts,
    mesh: TexturedMesh,
    mass: float,
    our_from_metres: Array,
    content: str,
    reading: Reading,
) -> LibraryEntry:
    """The entry of an object, its id without a suffix yet.

    Args:
        source: Where it was found.
        order: How it is added.
        facts: What its data set says, the order's own words filled in.
        mesh: In its resting pose.
        mass: Kilograms.
        our_from_metres: From the file's axes, in metres, to ours, shape (4, 4).
        content: Hash of its files.
        reading: Which axis of the file was taken to point up.
    """
    name = words_of(facts)
    x, y, z = (round(float(edge), 4) for edge in mesh.extent)
    w, a, b, c = (float(v) for v in quaternion_of(our_from_metres[:3, :3]))
    axes, poses = moved_symmetries(facts.symmetries, our_from_metres)
    return LibraryEntry(
        id=object_id(facts.name),
        name=name,
        category=category_of(facts),
        colours=said_colours(colours_at(mesh, *spots(mesh.vertices, mesh.faces, COLOUR_SPOTS))),
        description=described(name),
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
        shift=three(our_from_metres[:3, 3]),
        symmetries_continuous=axes,
        symmetries_discrete=poses,
        up=reading.up,
        up_sure=reading.sure,
        remarks=facts.remarks,
    )


def _provenance(facts: SourceFacts) -> dict[str, Provenance]:
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


def moved_symmetries(
    symmetries: Symmetries, our_from_metres: Array
) -> tuple[tuple[TurningSymmetry, ...], tuple[tuple[float, ...], ...]]:
    """Symmetries of the file's frame as those of ours."""
    rotation, shift = our_from_metres[:3, :3], our_from_metres[:3, 3]
    axes = tuple(
        TurningSymmetry(axis=three(rotation @ axis), offset=three(rotation @ point + shift))
        for axis, point in symmetries.axes
    )
    back = np.linalg.inv(our_from_metres)
    poses = [our_from_metres @ pose @ back for pose in symmetries.poses]
    return axes, tuple(tuple(float(v) for v in pose.reshape(-1)) for pose in poses)


def three(vector: Array) -> Vector3:
    """A vector, shape (3,), as plain numbers."""
    x, y, z = (float(v) for v in vector)
    return (x, y, z)
