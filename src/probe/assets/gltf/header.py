"""Refuse a glTF file by its header, before anything large is read. Knows no geometry."""

from __future__ import annotations

import json
import struct
from pathlib import Path
from typing import Any, cast

from probe.assets.gltf.indices import check_indices
from probe.assets.gltf.tree import check_counts, check_nodes
from probe.assets.gltf.uris import check_images, check_uris
from probe.assets.mesh.shaping import EXPORT_AGAIN
from probe.errors import BadMesh
from probe.reading import opened

MAX_JSON_BYTES = 64 * 2**20
MAX_BYTES = 2**30
UNDERSTOOD = {"KHR_materials_unlit", "KHR_materials_specular", "KHR_materials_ior"}


def check_header(path: Path) -> None:
    """Check sizes, counts, nodes, extensions, pictures and outside files that a glTF names.

    Follows "GLB File Format Specification" in glTF 2.0 (Khronos): a header of 12 bytes, then
    chunks, of which the first is JSON.

    Raises:
        BadMesh: Unreadable, truncated, no glTF, too large, nodes that are no tree, an extension
            that the geometry needs and we can't read, or a URI outside the file's folder.
    """
    tree, data_start = read_tree(path)
    try:
        required = {str(name) for name in tree.get("extensionsRequired", [])} - UNDERSTOOD
    except TypeError as error:
        raise BadMesh(path, "its list of extensions is malformed", f"{EXPORT_AGAIN}.") from error
    if required:
        listed = ", ".join(sorted(required))
        raise BadMesh(path, f"needs the glTF extension {listed}", f"{EXPORT_AGAIN}, uncompressed.")
    check_uris(path, tree)
    check_counts(path, tree)
    check_nodes(path, tree)
    check_indices(path, tree)
    check_images(path, tree, data_start)


def read_tree(path: Path) -> tuple[dict[str, Any], int]:
    """The JSON of a glTF file, and the byte at which the data of a GLB's binary chunk begins.

    Raises:
        BadMesh: Unreadable, truncated, too large, or no glTF.
    """
    try:
        size = path.stat().st_size
        if size > MAX_BYTES:
            remedy = "Reduce its triangles and textures."
            raise BadMesh(path, f"the file has {size / 2**20:,.0f} MB", remedy)
        with opened(path) as file:
            if size == 0:
                raise BadMesh(path, "the file is empty", "Copy or download it again.")
            start, length = 0, size
            if path.suffix.lower() != ".gltf":
                start, length = 20, _json_length(path, size, file.read(20))
            if length > MAX_JSON_BYTES:
                reason = f"its JSON has {length / 2**20:,.0f} MB"
                raise BadMesh(path, reason, f"{EXPORT_AGAIN}.")
            tree = json.loads(file.read(length))
    except OSError as error:
        reason = error.strerror or "can't be read"
        raise BadMesh(path, reason, "Check the path and its permissions.") from error
    except (ValueError, RecursionError) as error:
        raise BadMesh(path, "its JSON chunk is damaged", f"{EXPORT_AGAIN}.") from error
    if not isinstance(tree, dict):
        raise BadMesh(path, "its JSON chunk is no glTF tree", f"{EXPORT_AGAIN}.")
    return cast(dict[str, Any], tree), start + length + 8


def _json_length(path: Path, size: int, head: bytes) -> int:
    """Bytes of the JSON chunk of a GLB of that size that begins with these 20 bytes."""
    if len(head) < 20 or head[:4] != b"glTF":
        raise BadMesh(path, "this is no GLB file", f"{EXPORT_AGAIN}.")
    version, length, json_length = struct.unpack("<4xIII4x", head)
    if version != 2:
        raise BadMesh(path, f"glTF version {version} is not supported", f"{EXPORT_AGAIN}.")
    if length > size or json_length > size:
        reason = f"truncated: {size} of {length} bytes are there"
        raise BadMesh(path, reason, "Copy or download it again.")
    return json_length
