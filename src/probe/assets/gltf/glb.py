"""Read a glTF or GLB file as a textured mesh in our frame. Knows no catalogue and no physics."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, cast

import numpy as np
from PIL import Image
from scipy.spatial.transform import Rotation

from probe.assets.gltf.header import check_header
from probe.assets.mesh.mesh import TexturedMesh
from probe.assets.mesh.shaping import EXPORT_AGAIN, joined, placed, textured
from probe.errors import BadMesh
from probe.types import Array, Vector3

# Its import takes 0.3 s, and most processes find what files hold in the cache.
if TYPE_CHECKING:
    import trimesh


def glb_bytes(mesh: TexturedMesh, licence: str = "") -> bytes:
    """A binary glTF 2.0 file: metres, y up, the texture inside as PNG.

    Args:
        mesh: In our frame.
        licence: For the file's "copyright".
    """
    import trimesh
    from trimesh.visual.material import PBRMaterial
    from trimesh.visual.texture import TextureVisuals

    surface = mesh.surface
    material = PBRMaterial(
        baseColorTexture=Image.fromarray(surface.texture),
        roughnessFactor=surface.roughness,
        metallicFactor=surface.metallic,
    )
    uv = np.column_stack([mesh.uvs[:, 0], 1.0 - mesh.uvs[:, 1]])
    part = trimesh.Trimesh(
        mesh.vertices @ Z_UP_FROM_Y_UP,
        mesh.faces,
        visual=TextureVisuals(uv=uv, material=material),
        process=False,
    )
    scene = trimesh.Scene({"object": part})

    def stamp(tree: dict[str, object]) -> None:
        tree["asset"] = {"version": "2.0", "generator": "PROBE", "copyright": licence}

    return cast(bytes, scene.export(file_type="glb", tree_postprocessor=stamp))


GLB_VERSION = 1
"""To be raised when the mesh read from any file changes: caches are keyed by it."""

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
    return textured(path, read_gltf(path), _our_from_file(up_euler_deg))


def measure_glb(path: Path, up_euler_deg: Vector3 = (0.0, 0.0, 0.0)) -> Vector3:
    """Size along x, y, z in metres of what `load_glb` would return, at a tenth of the cost.

    Raises:
        BadMesh: The file's geometry can't be used.
    """
    vertices, faces = placed(path, read_gltf(path), _our_from_file(up_euler_deg))
    x, y, z = (float(v) for v in np.ptp(vertices[np.unique(faces)], axis=0))
    return (x, y, z)


def read_gltf(path: Path) -> trimesh.Trimesh:
    """All triangles of a ``.glb`` or ``.gltf`` as one mesh, in the file's axes (y up).

    Raises:
        BadMesh: Its header is refused, it can't be parsed, or it holds nothing of use.
    """
    import trimesh

    check_header(path)
    kind = "gltf" if path.suffix.lower() == ".gltf" else "glb"
    try:
        scene = trimesh.load_scene(path, file_type=kind, process=False)
        parts = [part for part in scene.dump() if isinstance(part, trimesh.Trimesh)]
    except Exception as error:
        # The parser meets hostile bytes here and may raise anything; the cause stays attached.
        raise BadMesh(path, f"can't be parsed ({error})", f"{EXPORT_AGAIN}.") from error
    return joined(path, parts)


def _our_from_file(up_euler_deg: Vector3) -> Array:
    turn = Rotation.from_euler("xyz", up_euler_deg, degrees=True).as_matrix()
    return turn @ Z_UP_FROM_Y_UP
