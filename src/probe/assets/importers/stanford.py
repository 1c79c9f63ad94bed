"""Stanford PLY with a texture named in a comment: checked by its header before it is parsed."""

from __future__ import annotations

import io
import re
from pathlib import Path

import trimesh
from trimesh.resolvers import FilePathResolver

from probe.assets.confined import confined
from probe.assets.gltf.tree import MAX_TRIANGLES, MAX_VERTICES
from probe.assets.mesh.shaping import joined
from probe.assets.pictures import check_picture
from probe.errors import BadMesh
from probe.reading import opened

MAX_BYTES = 2**29
MAX_HEADER = 2**16
_ELEMENT = re.compile(r"^element[ \t]+(\w+)[ \t]+(\d+)[ \t]*$", re.M)
_TEXTURE = re.compile(r"^comment[ \t]+TextureFile[ \t]+(.+?)[ \t]*$", re.M | re.I)


def ply_texture(path: Path, root: Path) -> Path:
    """The texture that a PLY names, both checked by their headers.

    Raises:
        BadMesh: The PLY or its texture can't be used.
    """
    header = _header(path)
    counts = {name: int(count[:12]) for name, count in _ELEMENT.findall(header)}
    vertices, faces = counts.get("vertex", 0), counts.get("face", 0)
    if not faces:
        raise BadMesh(path, "contains no triangles", "Export the model's mesh, not only points.")
    if max(vertices - MAX_VERTICES, max(counts.values()) - MAX_TRIANGLES) > 0:
        reason = f"its header claims {faces:,} triangles and {vertices:,} vertices"
        remedy = f"Decimate it to at most {MAX_TRIANGLES:,} triangles (20,000 are plenty)."
        raise BadMesh(path, reason, remedy)
    named = _TEXTURE.search(header)
    if named is None:
        raise BadMesh(path, "names no texture (comment TextureFile)", "Bake its colours into one.")
    texture = confined(path, named.group(1), path.parent, root=root)
    check_picture(path, texture)
    return texture


def read_ply(path: Path, root: Path) -> trimesh.Trimesh:
    """The triangles of a PLY, in its own frame.

    Raises:
        BadMesh: It can't be parsed, or lacks triangles, texture coordinates or a texture.
    """
    ply_texture(path, root)
    try:
        resolver = FilePathResolver(str(path))
        scene = trimesh.load_scene(
            io.BytesIO(path.read_bytes()), file_type="ply", resolver=resolver, process=False
        )
        parts = [part for part in scene.dump() if isinstance(part, trimesh.Trimesh)]
    except Exception as error:
        # The parser meets hostile bytes here and may raise anything; the cause stays attached.
        remedy = "Copy or download it again."
        raise BadMesh(path, f"truncated or damaged ({error})", remedy) from error
    return joined(path, parts)


def _header(path: Path) -> str:
    try:
        size = path.stat().st_size
        with opened(path) as file:
            head = file.read(MAX_HEADER)
    except OSError as error:
        reason = error.strerror or "can't be read"
        raise BadMesh(path, reason, "Check the path and its permissions.") from error
    if size == 0:
        raise BadMesh(path, "the file is empty", "Copy or download it again.")
    if size > MAX_BYTES:
        raise BadMesh(path, f"has {size / 2**20:,.0f} MB", "Decimate it.")
    text, end, _ = head.replace(b"\r\n", b"\n").partition(b"\nend_header\n")
    if not text.startswith(b"ply\n") or not end:
        raise BadMesh(path, "this is no PLY file", "Copy or download it again.")
    return text.decode("utf-8", "replace")
