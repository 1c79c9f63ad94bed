"""Refuse a GLB by its header, before anything large is read. Knows no geometry."""

from __future__ import annotations

import json
import struct
from pathlib import Path
from typing import Any, cast
from urllib.parse import unquote

from probe.errors import BadMesh

MAX_TRIANGLES = 2_000_000
MAX_VERTICES = 3 * MAX_TRIANGLES
TRIANGLES = 4
EXPORT_AGAIN = "Export the model again as binary glTF 2.0 (.glb) with its texture inside"
UNDERSTOOD = {"KHR_materials_unlit", "KHR_materials_specular", "KHR_materials_ior"}


def check_header(path: Path) -> None:
    """Check sizes, counts, extensions and outside files that a GLB names.

    Follows "GLB File Format Specification" in glTF 2.0 (Khronos): a header of 12 bytes, then
    chunks, of which the first is JSON.

    Raises:
        BadMesh: Unreadable, truncated, no GLB, too many triangles, an extension that the
            geometry needs and we can't read, or a URI outside the file's folder.
    """
    tree = read_tree(path)
    required = set(tree.get("extensionsRequired", [])) - UNDERSTOOD
    if required:
        listed = ", ".join(sorted(str(name) for name in required))
        raise BadMesh(path, f"needs the glTF extension {listed}", f"{EXPORT_AGAIN}, uncompressed.")
    _check_uris(path, tree)
    _check_counts(path, tree)


def read_tree(path: Path) -> dict[str, Any]:
    """The JSON chunk of a GLB.

    Raises:
        BadMesh: Unreadable, truncated, or no GLB.
    """
    try:
        size = path.stat().st_size
        with path.open("rb") as file:
            head = file.read(20)
            if size == 0:
                raise BadMesh(path, "the file is empty", "Copy or download it again.")
            if len(head) < 20 or head[:4] != b"glTF":
                raise BadMesh(path, "this is no GLB file", f"{EXPORT_AGAIN}.")
            version, length, json_length = struct.unpack("<4xIII4x", head)
            if version != 2:
                raise BadMesh(path, f"glTF version {version} is not supported", f"{EXPORT_AGAIN}.")
            if length > size or json_length > size:
                reason = f"truncated: {size} of {length} bytes are there"
                raise BadMesh(path, reason, "Copy or download it again.")
            tree = json.loads(file.read(json_length))
    except OSError as error:
        reason = error.strerror or "can't be read"
        raise BadMesh(path, reason, "Check the path and its permissions.") from error
    except (ValueError, RecursionError) as error:
        raise BadMesh(path, "its JSON chunk is damaged", f"{EXPORT_AGAIN}.") from error
    if not isinstance(tree, dict):
        raise BadMesh(path, "its JSON chunk is no glTF tree", f"{EXPORT_AGAIN}.")
    return cast(dict[str, Any], tree)


def _check_uris(path: Path, tree: dict[str, Any]) -> None:
    folder = path.parent.resolve()
    try:
        entries = [*tree.get("buffers", []), *tree.get("images", [])]
        uris = [str(entry["uri"]) for entry in entries if "uri" in entry]
    except (TypeError, KeyError) as error:
        raise BadMesh(path, "its buffers or images are malformed", f"{EXPORT_AGAIN}.") from error
    for uri in uris:
        if uri.startswith("data:"):
            continue
        inside = (folder / unquote(uri)).resolve().is_relative_to(folder)
        if "://" in uri or "\x00" in uri or not inside:
            reason = f"refers to {uri[:80]!r} outside its own folder"
            raise BadMesh(path, reason, f"{EXPORT_AGAIN}.")


def _check_counts(path: Path, tree: dict[str, Any]) -> None:
    try:
        triangles, vertices = _counts(tree)
    except (TypeError, KeyError, IndexError, ValueError) as error:
        raise BadMesh(path, "its accessors are malformed", f"{EXPORT_AGAIN}.") from error
    if triangles > MAX_TRIANGLES or vertices > MAX_VERTICES:
        reason = f"has {triangles:,} triangles and {vertices:,} vertices"
        remedy = f"Decimate it to at most {MAX_TRIANGLES:,} triangles (20,000 are plenty)."
        raise BadMesh(path, reason, remedy)


def _counts(tree: dict[str, Any]) -> tuple[int, int]:
    """Triangles and vertices over all meshes, each as often as a node shows it."""
    accessors = tree.get("accessors", [])
    shown = [node.get("mesh") for node in tree.get("nodes", [])]
    triangles = vertices = 0
    for number, mesh in enumerate(tree.get("meshes", [])):
        times = max(1, shown.count(number))
        for primitive in mesh["primitives"]:
            if primitive.get("mode", TRIANGLES) < TRIANGLES:
                continue
            corners = int(accessors[primitive["attributes"]["POSITION"]]["count"])
            vertices += times * corners
            if "indices" in primitive:
                corners = int(accessors[primitive["indices"]]["count"])
            strip = primitive.get("mode", TRIANGLES) != TRIANGLES
            triangles += times * (corners if strip else corners // 3)
    return triangles, vertices
