"""Specs and bodies of the procedural objects, through the cache."""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache

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
        data: Where the data files' entries are kept.
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

    To read the files takes as long as to build ten objects. So all entries are kept together, and
    an object's own is the only one that is made of the text.
    """
    texts = _texts(cache)
    if object_id not in texts:
        raise UnknownName("procedural object", object_id, list(texts))
    return ProceduralEntry.model_validate_json(texts[object_id])


@lru_cache(maxsize=1)
def _texts(cache: Cache) -> dict[str, bytes]:
    """Every object's entry as JSON, by id."""
    key = content_key("procedural entries", LAYOUT, recipe(_PACKAGE))
    stored = cache.load(key)
    if stored is None:
        known = entries(NEWEST_EDITION)
        texts = (entry.model_dump_json() for entry in known.values())
        stored = {"ids": _lines(known), "texts": _lines(texts)}
        cache.store(key, stored)
    ids, texts = (stored[name].tobytes().splitlines() for name in ("ids", "texts"))
    return {id.decode(): text for id, text in zip(ids, texts, strict=True)}


def _lines(texts: Iterable[str]) -> Array:
    return np.frombuffer("\n".join(texts).encode(), np.uint8)


def body_to_compare(object_id: str) -> Body:
    """A procedural object with a texture of half the usual size, enough to tell near-duplicates.

    Raises:
        UnknownName: No procedural object has this id.
    """
    return build(object_id, side_px=SIDE_PX // 2)
