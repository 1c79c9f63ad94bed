"""A textured triangle mesh as a value: arrays in, arrays out. Knows no file format."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass, field

import numpy as np

from probe.types import Array


@dataclass(frozen=True, eq=False)
class Material:
    """How a mesh takes light.

    Attributes:
        texture: Base colour in sRGB, uint8, shape (h, w, 3); row 0 is the top of the image.
        roughness: 0 (mirror) to 1 (chalk); where there is a map, its mean.
        metallic: 0 (plastic, paint, wood) or 1 (bare metal).
        normal: Tangent-space normals, OpenGL (green up), uint8, shape (h, w, 3), or None.
        roughness_map: Roughness times 255, uint8, shape (h, w), or None.
    """

    texture: Array
    roughness: float = 0.6
    metallic: float = 0.0
    normal: Array | None = None
    roughness_map: Array | None = None


@dataclass(frozen=True, eq=False)
class TexturedMesh:
    """Triangles with one texture, in metres, z up, resting on z = 0, centred over the origin.

    Attributes:
        vertices: float32, shape (n, 3).
        normals: Unit vectors, float32, shape (n, 3).
        uvs: Texture coordinates, (0, 0) at the texture's *top left*, float32, shape (n, 2).
        faces: Vertex indices, counter-clockwise from outside, int32, shape (m, 3).
        surface: Texture and material.
    """

    vertices: Array
    normals: Array
    uvs: Array
    faces: Array
    surface: Material

    @property
    def extent(self) -> Array:
        """Size along x, y, z in metres, shape (3,)."""
        return np.ptp(self.vertices, axis=0)

    def digest(self) -> str:
        """Content hash of geometry and look; 16 hex digits."""
        content = hashlib.sha256()
        for array in (self.vertices, self.normals, self.uvs, self.faces, self.surface.texture):
            content.update(np.ascontiguousarray(array).tobytes())
        content.update(f"{self.surface.roughness} {self.surface.metallic}".encode())
        return content.hexdigest()[:16]


@dataclass(frozen=True, eq=False)
class ConvexPiece:
    """One convex part of an object's collision shape: its hull's corners, float64, shape (k, 3)."""

    vertices: Array


@dataclass(frozen=True, eq=False)
class Body:
    """What physics and pictures need of an object: its mesh and its convex pieces."""

    mesh: TexturedMesh
    pieces: tuple[ConvexPiece, ...] = field(default=())

    def unpainted(self) -> Body:
        """The same shape in plain grey."""
        return Body(unpainted(self.mesh.vertices, self.mesh.normals, self.mesh.faces), self.pieces)


def unpainted(vertices: Array, normals: Array, faces: Array) -> TexturedMesh:
    """A mesh of one grey pixel, where only its shape matters.

    Caches hold such meshes: raise `packing.LAYOUT` if they are to be made otherwise.
    """
    grey = Material(np.full((1, 1, 3), 128, dtype=np.uint8))
    return TexturedMesh(vertices, normals, np.zeros((len(vertices), 2), np.float32), faces, grey)
