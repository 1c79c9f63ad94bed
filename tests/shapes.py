"""Small textured meshes that tests make for themselves."""

from __future__ import annotations

import numpy as np
import trimesh

from probe.assets.mesh.mesh import Material, TexturedMesh
from probe.render.protocol import TableTop
from probe.scene.setup import UR5_TABLE


def textured(shape: trimesh.Trimesh, texture: np.ndarray) -> TexturedMesh:
    """A mesh with flat shading and every texture coordinate in the middle."""
    shape = shape.copy()
    shape.unmerge_vertices()
    normals = np.repeat(shape.face_normals, 3, axis=0)
    uvs = np.full((len(shape.vertices), 2), 0.5)
    return TexturedMesh(
        shape.vertices.astype(np.float32),
        normals.astype(np.float32),
        uvs.astype(np.float32),
        np.asarray(shape.faces, np.int32),
        Material(texture),
    )


def plain(*colour: int) -> np.ndarray:
    """A one-pixel texture."""
    return np.array([[colour]], dtype=np.uint8)


def box(x: float, y: float, z: float, *colour: int) -> TexturedMesh:
    """A box resting on z = 0."""
    shape = trimesh.creation.box((x, y, z))
    shape.apply_translation((0, 0, z / 2))
    return textured(shape, plain(*colour))


def card(size: float, texture: np.ndarray) -> TexturedMesh:
    """A flat square facing up, with the whole texture on it, its top towards +y."""
    half = size / 2
    vertices = [[-half, half, 0], [-half, -half, 0], [half, -half, 0], [half, half, 0]]
    return TexturedMesh(
        np.array(vertices, np.float32),
        np.tile(np.array([0, 0, 1], np.float32), (4, 1)),
        np.array([[0, 0], [0, 1], [1, 1], [1, 0]], np.float32),
        np.array([[0, 1, 2], [0, 2, 3]], np.int32),
        Material(texture),
    )


def grey_table() -> TableTop:
    """A plain table top."""
    return TableTop(Material(plain(120, 120, 120)), 1.0, UR5_TABLE.table_size)
