"""Meshes as the renderer's buffers take them. Knows no engine."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from probe.assets.mesh.mesh import Material, TexturedMesh
from probe.render.protocol import TableTop
from probe.types import Array


@dataclass(frozen=True, eq=False)
class PackedMesh:
    """A mesh as vertex and index buffers.

    Attributes:
        vertices: float32; position, tangent frame (xyzw) and texture coordinates interleaved.
        indices: uint32, three a triangle.
        bounds: Lowest and highest corner in metres.
    """

    vertices: bytes
    indices: bytes
    vertex_count: int
    index_count: int
    bounds: tuple[Array, Array]
    surface: Material


def pack(mesh: TexturedMesh) -> PackedMesh:
    """Interleave position, tangent frame and texture coordinates."""
    columns = [mesh.vertices, _tangent_frames(mesh.normals), mesh.uvs]
    return PackedMesh(
        vertices=np.concatenate(columns, axis=1).astype(np.float32).tobytes(),
        indices=mesh.faces.astype(np.uint32).tobytes(),
        vertex_count=len(mesh.vertices),
        index_count=mesh.faces.size,
        bounds=(mesh.vertices.min(0).astype(np.float32), mesh.vertices.max(0).astype(np.float32)),
        surface=mesh.surface,
    )


def table_quad(table: TableTop) -> TexturedMesh:
    """The table's top as one quad at z = 0, its texture repeated."""
    corners = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], dtype=np.float32)
    vertices = corners * np.array([*table.extent, 0.0], dtype=np.float32) / 2
    uvs = vertices[:, :2] * np.array([1, -1], np.float32) / np.float32(table.tile_size)
    normals = np.tile(np.array([0, 0, 1], np.float32), (4, 1))
    faces = np.array([[0, 1, 2], [0, 2, 3]], dtype=np.int32)
    return TexturedMesh(vertices, normals, uvs, faces, table.surface)


def _tangent_frames(normals: Array) -> Array:
    """Quaternions xyzw, shape (n, 4), that turn +z into each normal by the shortest way."""
    w = 1 + normals[:, 2]
    frames = np.stack([-normals[:, 1], normals[:, 0], np.zeros(len(normals)), w], axis=1)
    frames[w < 1e-6] = (1, 0, 0, 0)
    return frames / np.linalg.norm(frames, axis=1, keepdims=True)
