"""Write a textured mesh as a GLB that `load_glb` reads back."""

from __future__ import annotations

from typing import cast

import numpy as np
import trimesh
from PIL import Image
from trimesh.visual.material import PBRMaterial
from trimesh.visual.texture import TextureVisuals

from probe.assets.gltf.glb import Z_UP_FROM_Y_UP
from probe.assets.mesh.mesh import TexturedMesh


def glb_bytes(mesh: TexturedMesh, licence: str = "") -> bytes:
    """A binary glTF 2.0 file: metres, y up, the texture inside as PNG.

    Args:
        mesh: In our frame.
        licence: For the file's "copyright".
    """
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
