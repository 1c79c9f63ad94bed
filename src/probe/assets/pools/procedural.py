"""Specs and bodies of the procedural objects, through the cache."""

from __future__ import annotations

import json
from collections.abc import Mapping

import numpy as np

from probe.assets.cache import Cache, content_key
from probe.assets.looks import Looks
from probe.assets.mesh.mesh import Body
from probe.assets.mesh.packing import LAYOUT, pack_body, pack_specs, unpack_body, unpack_specs
from probe.assets.procedural import build, specs
from probe.assets.procedural.atlas import SIDE_PX
from probe.assets.procedural.catalogue import build_entry, build_form
from probe.assets.procedural.tables import NEWEST_EDITION, Edition, ProceduralEntry, entries
from probe.assets.recipes import recipe
from probe.assets.spec import ObjectSpec
from probe.errors import UnknownName
from probe.types import Array

_PACKAGE = "probe.assets.procedural"


def procedural_specs(cache: Cache, edition: Edition) -> tuple[ObjectSpec, ...]:
    """All procedural objects of an edition."""
    key = content_key("procedural specs", LAYOUT, recipe(_PACKAGE), str(edition))
    stored = cache.load(key)
    found = None if stored is None else unpack_specs(stored)
    if found is None:
        found = specs(edition)
        cache.store(key, pack_specs(found))
    return found


def procedural_key(object_id: str, looks: Looks) -> str:
    """The key of an object's body in the cache."""
    return content_key("procedural body", LAYOUT, recipe(_PACKAGE), object_id, str(looks))


def procedural_body(object_id: str, bodies: Cache, data: Cache, looks: Looks = 1) -> Body:
    """Mesh and convex pieces of a procedural object.

    Args:
        object_id: Which.
        bodies: Where bodies are kept.
        data: Where it is kept what the data files say.
        looks: How its surface looks.

    Raises:
        UnknownName: No procedural object has this id.
        OutputFailed: The cache can't be written.
    """
    key = procedural_key(object_id, looks)
    stored = bodies.load(key)
    if stored is not None:
        return unpack_body(stored)
    body = build_entry(_entry(object_id, data), looks)
    bodies.store(key, pack_body(body))
    return body


def procedural_form(object_id: str, data: Cache) -> Body:
    """As procedural_body(), unpainted and not kept.

    Raises:
        UnknownName: No procedural object has this id.
        OutputFailed: The cache can't be written.
    """
    return build_form(_entry(object_id, data))


def _entry(object_id: str, cache: Cache) -> ProceduralEntry:
    """What the data files say of an object.

    To read them all takes as long as to build ten objects, so what they say is kept, and one
    object's share of it is read.
    """
    key = content_key("procedural entries", recipe(_PACKAGE))
    stored = cache.load(key)
    if stored is None:
        stored = _packed(entries(NEWEST_EDITION))
        cache.store(key, stored)
    ids = json.loads(stored["ids"].tobytes())
    if object_id not in ids:
        raise UnknownName("procedural object", object_id, ids)
    start, end = stored["ends"][ids.index(object_id) :][:2]
    return ProceduralEntry.model_validate_json(stored["texts"][start:end].tobytes())


def _packed(known: Mapping[str, ProceduralEntry]) -> dict[str, Array]:
    """Entries as JSON in one row of bytes, where each ends, and whose they are."""
    texts = [entry.model_dump_json().encode() for entry in known.values()]
    return {
        "ids": np.frombuffer(json.dumps(list(known)).encode(), np.uint8),
        "ends": np.cumsum([0, *map(len, texts)]),
        "texts": np.frombuffer(b"".join(texts), np.uint8),
    }


def body_to_compare(object_id: str) -> Body:
    """A procedural object with a texture of half the usual size, enough to tell near-duplicates.

    Raises:
        UnknownName: No procedural object has this id.
    """
    return build(object_id, side_px=SIDE_PX // 2)
