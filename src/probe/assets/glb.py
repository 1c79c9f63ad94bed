"""Read a GLB file as a textured mesh in our frame. Knows no catalogue and no physics."""

from __future__ import annotations

from pathlib import Path
from typing import Any, cast

import numpy as np
import trimesh
from PIL import Image
from scipy.spatial.transform import Rotation

from probe.assets.glb_header import EXPORT_AGAIN, check_header
from probe.assets.mesh import Surface, TexturedMesh
from probe.assets.normals import smooth_normals
from probe.errors import BadMesh
from probe.types import Array, Vector3

GLB_VERSION = 1
"""To be raised when the mesh read from any file changes: caches are keyed by it."""

LARGEST = 2.0
SMALLEST = 0.005
MAX_TEXTURE_PX = 8192
Z_UP_FROM_Y_UP = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])


def load_glb(path: Path, up_euler_deg: Vector3 = (0.0, 0.0, 0.0)) -> TexturedMesh:
    """Load a GLB: z up, resting on z = 0, its bounding box centred over the origin.

    Args:
        path: A binary glTF 2.0 file in metres, y up, with a base colour texture.
        up_euler_deg: Turns about the fixed x, then y, then z axis, in degrees, that bring the
            model (already z up) into its resting pose.

    Raises:
        BadMesh: The file can't be used; says why and what to do about it.
    """
    part, vertices, faces = _placed(path, up_euler_deg)
    uvs = _uvs(path, part)
    surface = _surface(path, cast(Any, part.visual).material)
    old, normals, faces = smooth_normals(vertices, faces)
    return TexturedMesh(
        vertices[old].astype(np.float32), normals, uvs[old].astype(np.float32), faces, surface
    )


def measure_glb(path: Path, up_euler_deg: Vector3 = (0.0, 0.0, 0.0)) -> Vector3:
    """Size along x, y, z in metres of what `load_glb` would return, at a tenth of the cost.

    Raises:
        BadMesh: The file's geometry can't be used.
    """
    _, vertices, faces = _placed(path, up_euler_deg)
    x, y, z = (float(v) for v in np.ptp(vertices[np.unique(faces)], axis=0))
    return (x, y, z)


def centred(vertices: Array, faces: Array) -> Array:
    """Vertices moved so that those in use rest on z = 0, their box centred in x and y."""
    used = vertices[np.unique(faces)]
    low, high = used.min(axis=0), used.max(axis=0)
    middle = (low + high) / 2
    return vertices - np.array([middle[0], middle[1], low[2]])


def _placed(path: Path, up_euler_deg: Vector3) -> tuple[trimesh.Trimesh, Array, Array]:
    """A file's mesh as read, and its vertices and faces checked and in our frame."""
    check_header(path)
    part = _read(path)
    vertices, faces = np.asarray(part.vertices, np.float64), np.asarray(part.faces, np.int64)
    _check_geometry(path, vertices, faces)
    rotation = Rotation.from_euler("xyz", up_euler_deg, degrees=True).as_matrix()
    vertices = vertices @ (rotation @ Z_UP_FROM_Y_UP).T
    faces = _solid_faces(path, vertices, faces)
    vertices = centred(vertices, faces)
    _check_size(path, vertices[np.unique(faces)])
    return part, vertices, faces


def _read(path: Path) -> trimesh.Trimesh:
    """All triangles of a file as one mesh, y up; several materials become one atlas."""
    try:
        scene = trimesh.load_scene(path, file_type="glb", process=False)
        parts = [part for part in scene.dump() if isinstance(part, trimesh.Trimesh)]
    except Exception as error:
        # The parser meets hostile bytes here and may raise anything; the cause stays attached.
        raise BadMesh(path, f"can't be parsed ({error})", f"{EXPORT_AGAIN}.") from error
    parts = [part for part in parts if len(part.faces)]
    if not parts:
        raise BadMesh(path, "contains no triangles", "Export the model's mesh, not only points.")
    if len(parts) == 1:
        return parts[0]
    for part in parts:
        _uvs(path, part)
        _surface(path, cast(Any, part.visual).material)
    return cast(trimesh.Trimesh, trimesh.util.concatenate(parts))


def _uvs(path: Path, part: trimesh.Trimesh) -> Array:
    """Texture coordinates from the top left, shape (n, 2); trimesh counts v from the bottom."""
    uv = cast(Any, getattr(part.visual, "uv", None))
    if uv is None or len(uv) != len(part.vertices):
        raise BadMesh(path, "has no texture coordinates", "Unwrap it and bake its colours.")
    uv = np.asarray(uv, dtype=np.float64)[:, :2]
    if not np.isfinite(uv).all():
        raise BadMesh(path, "has texture coordinates that are not finite", "Unwrap it again.")
    return np.column_stack([uv[:, 0], 1.0 - uv[:, 1]])


def _surface(path: Path, material: Any) -> Surface:
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
    return Surface(
        np.ascontiguousarray(texture),
        0.6 if roughness is None else float(np.clip(roughness, 0.0, 1.0)),
        0.0 if metallic is None else float(metallic > 0.5),
    )


def _check_geometry(path: Path, vertices: Array, faces: Array) -> None:
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
    if longest > LARGEST:
        reason = f"its longest side is {longest:.3g} m"
        remedy = "It looks like millimetres taken for metres: scale it by 0.001."
        raise BadMesh(path, reason, remedy)
    if longest < SMALLEST:
        reason = f"its longest side is {longest * 1000:.3g} mm"
        raise BadMesh(path, reason, "It looks like metres taken for millimetres: scale it by 1000.")
