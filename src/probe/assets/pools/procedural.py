"""Specs and bodies of the procedural objects, through the cache."""

from __future__ import annotations

from probe.assets.cache import Cache, content_key
from probe.assets.looks import Looks
from probe.assets.mesh.mesh import Body
from probe.assets.mesh.packing import LAYOUT, pack_body, pack_specs, unpack_body, unpack_specs
from probe.assets.procedural import build, specs
from probe.assets.procedural.atlas import SIDE_PX
from probe.assets.procedural.tables import Edition
from probe.assets.recipes import recipe
from probe.assets.spec import ObjectSpec

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


def procedural_body(object_id: str, cache: Cache, looks: Looks = 1) -> Body:
    """Mesh and convex pieces of a procedural object.

    Raises:
        UnknownName: No procedural object has this id.
        OutputFailed: The cache can't be written.
    """
    key = procedural_key(object_id, looks)
    stored = cache.load(key)
    if stored is not None:
        return unpack_body(stored)
    body = build(object_id, looks)
    cache.store(key, pack_body(body))
    return body


def body_to_compare(object_id: str) -> Body:
    """A procedural object with a texture of half the usual size, enough to tell near-duplicates.

    Raises:
        UnknownName: No procedural object has this id.
    """
    return build(object_id, side_px=SIDE_PX // 2)
