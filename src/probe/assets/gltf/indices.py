"""Refuse a glTF tree whose numbers lead to nothing, or turn by nothing. Reads no file.

Python counts a negative index from the end, so that one is read as something else in silence.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any, cast

from probe.assets.mesh.shaping import EXPORT_AGAIN
from probe.errors import BadMesh

_REFERENCES = {
    "accessors": {"bufferView": "bufferViews"},
    "bufferViews": {"buffer": "buffers"},
    "images": {"bufferView": "bufferViews"},
    "nodes": {"mesh": "meshes", "children": "nodes"},
    "scenes": {"nodes": "nodes"},
    "textures": {"source": "images", "sampler": "samplers"},
}
"""Where an entry of a list names entries of another one (glTF 2.0, "Properties Reference")."""

_LENGTHS = ("byteOffset", "byteLength", "byteStride", "count")
_UNIT = 0.01


def check_indices(path: Path, tree: dict[str, Any]) -> None:
    """See that whatever is named by its number is there, and that rotations are such.

    Raises:
        BadMesh: Something isn't; its place in the tree is named.
    """
    for place, index, target in _references(tree):
        there = len(_list(tree, target))
        if type(index) is not int or not 0 <= index < there:
            reason = f"{place} is {str(index)[:40]}, but it has {there} {target}"
            raise BadMesh(path, reason, f"{EXPORT_AGAIN}.")
    for place, value in _lengths(tree):
        if type(value) is not int or value < 0:
            raise BadMesh(path, f"{place} is {str(value)[:40]}", f"{EXPORT_AGAIN}.")
    for number, node in enumerate(_list(tree, "nodes")):
        if "rotation" in node and not _turns(node["rotation"]):
            raise BadMesh(path, f"nodes.{number}.rotation is no rotation", f"{EXPORT_AGAIN}.")


def _references(tree: dict[str, Any]) -> Iterator[tuple[str, object, str]]:
    """Where a number stands, the number, and the list that it is of."""
    for name, fields in _REFERENCES.items():
        for number, entry in enumerate(_list(tree, name)):
            for field, target in fields.items():
                named = entry.get(field, [])
                for each in cast("list[Any]", named if isinstance(named, list) else [named]):
                    yield f"{name}.{number}.{field}", each, target
    if "scene" in tree:
        yield "scene", tree["scene"], "scenes"
    yield from _of_meshes(tree)
    yield from _of_materials(tree)


def _of_meshes(tree: dict[str, Any]) -> Iterator[tuple[str, object, str]]:
    for number, mesh in enumerate(_list(tree, "meshes")):
        for at, part in enumerate(_list(mesh, "primitives")):
            place = f"meshes.{number}.primitives.{at}"
            attributes = part.get("attributes")
            if isinstance(attributes, dict):
                for name, index in cast("dict[str, Any]", attributes).items():
                    yield f"{place}.{name}", index, "accessors"
            if "indices" in part:
                yield f"{place}.indices", part["indices"], "accessors"
            if "material" in part:
                yield f"{place}.material", part["material"], "materials"


def _of_materials(tree: dict[str, Any]) -> Iterator[tuple[str, object, str]]:
    for number, material in enumerate(_list(tree, "materials")):
        inner = material.get("pbrMetallicRoughness")
        for part in (material, cast("dict[str, Any]", inner) if isinstance(inner, dict) else {}):
            for name, value in part.items():
                if name.endswith("Texture") and isinstance(value, dict) and "index" in value:
                    index = cast("dict[str, Any]", value)["index"]
                    yield f"materials.{number}.{name}", index, "textures"


def _lengths(tree: dict[str, Any]) -> Iterator[tuple[str, object]]:
    for name in ("accessors", "bufferViews", "buffers"):
        for number, entry in enumerate(_list(tree, name)):
            for field in _LENGTHS:
                if field in entry:
                    yield f"{name}.{number}.{field}", entry[field]


def _list(tree: dict[str, Any], name: str) -> list[dict[str, Any]]:
    """A list of objects; what is none is for those to name who read it."""
    found = tree.get(name)
    some = cast("list[Any]", found) if isinstance(found, list) else []
    return [cast("dict[str, Any]", each) if isinstance(each, dict) else {} for each in some]


def _turns(rotation: object) -> bool:
    if not isinstance(rotation, list) or len(cast("list[Any]", rotation)) != 4:
        return False
    parts = cast("list[Any]", rotation)
    if not all(type(part) in (int, float) and math.isfinite(part) for part in parts):
        return False
    return abs(math.hypot(*parts) - 1) <= _UNIT
