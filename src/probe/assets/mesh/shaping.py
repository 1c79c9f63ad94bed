"""A parsed mesh, of whatever format, as a textured mesh in our frame; refuses what can't be one."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

import numpy as np
from PIL import Image

from probe.assets.mesh.mesh import Material, TexturedMesh
from probe.assets.mesh.normals import smooth_normals
from probe.errors import BadMesh
from probe.types import Array

if TYPE_CHECKING:
    import trimesh

EXPORT_AGAIN = "Export the model again as binary glTF 2.0 (.glb) with its texture inside"
LARGEST = 2.0
SMALLEST = 0.005
ABSURD = 10_000.0
MAX_TEXTURE_PX = 8192


def textured(path: Path, part: trimesh.Trimesh, our_from_file: Array) -> TexturedMesh:
    """A mesh resting on z = 0, its bounding box centred over the origin.

    Args:
        path: For messages.
        part: As parsed, in the file's units and axes.
        our_from_file: Rotation times metres per unit, shape (3, 3).

    Raises:
        BadMesh: It can't be used; says why and what to do about it.
    """
    vertices, faces = placed(path, part, our_from_file)
    uvs = _uvs(path, part)
    surface = _surface(path, cast(Any, part.visual).material)
    old, normals, faces = smooth_normals(vertices, faces)
    return TexturedMesh(
        vertices[old].astype(np.float32), normals, uvs[old].astype(np.float32), faces, surface
    )


def placed(path: Path, part: trimesh.Trimesh, our_from_file: Array) -> tuple[Array, Array]:
    """Vertices, float64, shape (n, 3), and faces, shape (m, 3), checked and in our frame.

    Raises:
        BadMesh: The geometry can't be used.
    """
    vertices, faces = np.asarray(part.vertices, np.float64), np.asarray(part.faces, np.int64)
    check_geometry(path, vertices, faces)
    vertices = vertices @ our_from_file.T
    faces = _solid_faces(path, vertices, faces)
    vertices = centred(vertices, faces)
    _check_size(path, vertices[np.unique(faces)])
    return vertices, faces


def centred(vertices: Array, faces: Array) -> Array:
    """Vertices moved so that those in use rest on z = 0, their box centred in x and y."""
    used = vertices[np.unique(faces)]
    low, high = used.min(axis=0), used.max(axis=0)
    middle = (low + high) / 2
    return vertices - np.array([middle[0], middle[1], low[2]])


def joined(path: Path, parts: Sequence[trimesh.Trimesh]) -> trimesh.Trimesh:
    """All parts with triangles as one mesh; several materials become one atlas.

    Raises:
        BadMesh: There are no triangles, or a part has no texture.
    """
    solid = [part for part in parts if len(part.faces)]
    if not solid:
        raise BadMesh(path, "contains no triangles", "Export the model's mesh, not only points.")
    if len(solid) == 1:
        return solid[0]
    for part in solid:
        _uvs(path, part)
        _surface(path, cast(Any, part.visual).material)
    import trimesh  # its import takes 0.3 s, and few files have several parts

    return cast(trimesh.Trimesh, trimesh.util.concatenate(solid))


def _uvs(path: Path, part: trimesh.Trimesh) -> Array:
    """Texture coordinates from the top left, shape (n, 2); trimesh counts v from the bottom."""
    uv = cast(Any, getattr(part.visual, "uv", None))
    if uv is None or len(uv) != len(part.vertices):
        raise BadMesh(path, "has no texture coordinates", "Unwrap it and bake its colours.")
    uv = np.asarray(uv, dtype=np.float64)[:, :2]
    if not np.isfinite(uv).all():
        raise BadMesh(path, "has texture coordinates that are not finite", "Unwrap it again.")
    return np.column_stack([uv[:, 0], 1.0 - uv[:, 1]])


def _surface(path: Path, material: Any) -> Material:
    image = cast(Any, getattr(material, "baseColorTexture", None))
    if image is None:
        image = cast(Any, getattr(material, "image", None))
    if not isinstance(image, Image.Image):
        remedy = "Bake its colours into a base colour texture and export it inside the GLB."
        raise BadMesh(path, "has no base colour texture", remedy)
    if max(image.size) > MAX_TEXTURE_PX:
        reason = f"its texture is {image.size[0]} x {image.size[1]} pixels"
        raise BadMesh(path, reason, f"Reduce it to at most {MAX_TEXTURE_PX} (1024 is plenty).")
    try:
        texture = np.asarray(image.convert("RGB"), dtype=np.uint8)
    except (OSError, ValueError, SyntaxError) as error:
        raise BadMesh(path, f"its texture is damaged ({error})", f"{EXPORT_AGAIN}.") from error
    roughness = cast(Any, getattr(material, "roughnessFactor", None))
    metallic = cast(Any, getattr(material, "metallicFactor", None))
    # glTF takes a missing metallicFactor for 1; exporters that leave it out mean plain paint.
    return Material(
        np.ascontiguousarray(texture),
        0.6 if roughness is None else float(np.clip(roughness, 0.0, 1.0)),
        0.0 if metallic is None else float(metallic > 0.5),
    )


def check_geometry(path: Path, vertices: Array, faces: Array) -> None:
    """Refuse vertices that are no numbers, and faces that name missing ones.

    Raises:
        BadMesh: There are such.
    """
    if not np.isfinite(vertices).all():
        raise BadMesh(path, "has vertices that are NaN or infinite", "Clean it in a mesh editor.")
    if faces.min() < 0 or faces.max() >= len(vertices):
        raise BadMesh(path, "has faces that name missing vertices", f"{EXPORT_AGAIN}.")


def _solid_faces(path: Path, vertices: Array, faces: Array) -> Array:
    """Faces without those of no area."""
    a, b, c = np.moveaxis(vertices[faces], 1, 0)
    kept = faces[np.linalg.norm(np.cross(b - a, c - a), axis=1) > 0]
    if not len(kept):
        raise BadMesh(path, "has only triangles of no area", "Export the model's mesh again.")
    return kept


def _check_size(path: Path, vertices: Array) -> None:
    longest = float(np.ptp(vertices, axis=0).max())
    if longest > ABSURD:
        remedy = "A scale in it is wrong: apply all scales in a mesh editor."
        raise BadMesh(path, f"its longest side is {longest:.3g} m", remedy)
    if longest > LARGEST:
        reason = f"its longest side is {longest:.3g} m"
        remedy = "It looks like millimetres taken for metres: scale it by 0.001."
        raise BadMesh(path, reason, remedy)
    if longest < SMALLEST:
        reason = f"its longest side is {longest * 1000:.3g} mm"
        raise BadMesh(path, reason, "It looks like metres taken for millimetres: scale it by 1000.")
