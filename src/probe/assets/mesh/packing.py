"""Bodies and specs as named arrays and back, for the cache. Knows no files."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from pydantic import TypeAdapter, ValidationError

from probe.assets.mesh.mesh import Body, ConvexPiece, Material, TexturedMesh
from probe.assets.spec import ObjectSpec
from probe.types import Array

LAYOUT = "1"
"""To be raised with any change here: part of every key."""

_SPECS = TypeAdapter(tuple[ObjectSpec, ...])


def pack_body(body: Body) -> dict[str, Array]:
    mesh, corners = body.mesh, [piece.vertices for piece in body.pieces]
    maps = {"normal": mesh.surface.normal, "roughness_map": mesh.surface.roughness_map}
    return {name: pixels for name, pixels in maps.items() if pixels is not None} | {
        "vertices": mesh.vertices,
        "normals": mesh.normals,
        "uvs": mesh.uvs,
        "faces": mesh.faces,
        "texture": mesh.surface.texture,
        "surface": np.array([mesh.surface.roughness, mesh.surface.metallic]),
        "corners": np.vstack(corners) if corners else np.zeros((0, 3)),
        "counts": np.array([len(piece) for piece in corners], dtype=np.int64),
    }


def unpack_body(arrays: Mapping[str, Array]) -> Body:
    roughness, metallic = (float(v) for v in arrays["surface"])
    maps = arrays.get("normal"), arrays.get("roughness_map")
    surface = Material(arrays["texture"], roughness, metallic, *maps)
    vertices, normals = arrays["vertices"], arrays["normals"]
    ends = np.cumsum(arrays["counts"])[:-1]
    parts = np.split(arrays["corners"], ends) if len(arrays["counts"]) else []
    pieces = tuple(ConvexPiece(part) for part in parts)
    return Body(TexturedMesh(vertices, normals, arrays["uvs"], arrays["faces"], surface), pieces)


def pack_specs(specs: Sequence[ObjectSpec]) -> dict[str, Array]:
    return {"json": np.frombuffer(_SPECS.dump_json(tuple(specs)), dtype=np.uint8)}


def unpack_specs(arrays: Mapping[str, Array]) -> tuple[ObjectSpec, ...] | None:
    """The specs, or None if they don't fit today's fields."""
    try:
        return _SPECS.validate_json(arrays["json"].tobytes())
    except (ValidationError, KeyError):
        return None
