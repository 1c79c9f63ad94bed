"""GLB files for tests: whole ones through trimesh, odd ones byte by byte."""

from __future__ import annotations

import json
import struct
from pathlib import Path
from typing import Any

import numpy as np
import trimesh
from PIL import Image
from trimesh.visual.material import PBRMaterial
from trimesh.visual.texture import TextureVisuals

# A file's y is our z, its -z our y.
FILE_FROM_Z_UP = np.array([[1.0, 0, 0, 0], [0, 0, 1, 0], [0, -1, 0, 0], [0, 0, 0, 1]])


def textured(
    mesh: trimesh.Trimesh, colour: tuple[int, int, int] = (200, 30, 30)
) -> trimesh.Trimesh:
    """A z-up mesh in one colour."""
    uv = np.full((len(mesh.vertices), 2), 0.5)
    material = PBRMaterial(baseColorTexture=Image.new("RGB", (8, 8), colour), metallicFactor=0.0)
    mesh.visual = TextureVisuals(uv=uv, material=material)
    return mesh


def write_glb(path: Path, *parts: trimesh.Trimesh) -> Path:
    """A GLB of z-up meshes, y up as glTF asks."""
    scene = trimesh.Scene([part.copy().apply_transform(FILE_FROM_Z_UP) for part in parts])
    content = scene.export(file_type="glb")
    assert isinstance(content, bytes)
    path.write_bytes(content)
    return path


def box_glb(path: Path, size: tuple[float, float, float] = (0.1, 0.06, 0.04)) -> Path:
    return write_glb(path, textured(trimesh.creation.box(size)))


def raw_glb(tree: Any, blob: bytes = b"") -> bytes:
    """A GLB of a JSON tree and a binary chunk (glTF 2.0, "GLB File Format Specification")."""
    text = json.dumps(tree).encode()
    text += b" " * (-len(text) % 4)
    blob += b"\0" * (-len(blob) % 4)
    chunks = struct.pack("<II", len(text), 0x4E4F534A) + text
    chunks += struct.pack("<II", len(blob), 0x004E4942) + blob
    return b"glTF" + struct.pack("<II", 2, 12 + len(chunks)) + chunks


def triangle_tree(blob: bytes, **changes: Any) -> dict[str, Any]:
    """A tree of one textured triangle: 36 bytes of positions, 24 of uvs, then a PNG."""
    png = len(blob) - 60
    tree = {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "scene": 0,
        "nodes": [{"mesh": 0}],
        "meshes": [
            {"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}]}
        ],
        "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
        "textures": [{"source": 0}],
        "images": [{"bufferView": 2, "mimeType": "image/png"}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": 36},
            {"buffer": 0, "byteOffset": 36, "byteLength": 24},
            {"buffer": 0, "byteOffset": 60, "byteLength": png},
        ],
        "buffers": [{"byteLength": len(blob)}],
    }
    return tree | changes
