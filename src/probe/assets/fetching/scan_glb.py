"""The files of one scan, as its source serves them, to the GLB that PROBE reads."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any, cast

import numpy as np
import trimesh
from PIL import Image
from trimesh.visual.material import PBRMaterial
from trimesh.visual.texture import TextureVisuals

from probe.assets.fetching.scan_manifest import ScanFile, ScanLayout
from probe.assets.gltf.glb import Z_UP_FROM_Y_UP
from probe.assets.gltf.header import check_header
from probe.assets.importers import IMPORTERS
from probe.assets.mesh.shaping import EXPORT_AGAIN
from probe.errors import BadMesh
from probe.types import Array

PAINTED = "texture.png"
"""The texture that is painted for a source without one."""

_QUALITY = 88
"""Of JPEG: how the textures of the scans of `v1-scans` were kept before they were embedded."""

_ROUGHNESS = 0.5
_AGAIN = "Download it again."


def scan_glb(scan: ScanFile, layout: ScanLayout, folder: Path) -> bytes:
    """A GLB made exactly as those were that `v1-scans` was made with.

    Args:
        scan: Its item and texture.
        layout: How its files lie.
        folder: Holds them.

    Raises:
        BadMesh: The files can't be used, or the item isn't among them.
    """
    if scan.colour is not None:
        Image.new("RGB", scan.texture_px, scan.colour).save(folder / PAINTED)
    part, turn = _part(scan, layout, folder)
    visual = cast(Any, part.visual)
    image = getattr(visual.material, "image", None)
    if image is None:
        image = getattr(visual.material, "baseColorTexture", None)
    if not isinstance(image, Image.Image):
        raise BadMesh(folder, "has no texture", _AGAIN)
    material = PBRMaterial(
        baseColorTexture=_kept(image, scan.texture_px),
        roughnessFactor=_ROUGHNESS,
        metallicFactor=0.0,
    )
    whole = trimesh.Trimesh(
        part.vertices @ turn,
        part.faces,
        visual=TextureVisuals(uv=visual.uv, material=material),
        process=False,
    )
    return cast(bytes, trimesh.Scene({"geometry_0": whole}).export(file_type="glb"))


def _part(scan: ScanFile, layout: ScanLayout, folder: Path) -> tuple[trimesh.Trimesh, Array]:
    """The triangles in their file's axes, and what turns rows of them to y up, shape (3, 3)."""
    if layout == "gltf":
        return _named_part(next(iter(sorted(folder.glob("*.gltf")))), scan.item), np.eye(3)
    importer = IMPORTERS[layout]
    found = importer.find(folder)
    if len(found) != 1:
        raise BadMesh(folder, f"holds {len(found)} objects in the layout {layout}", _AGAIN)
    return importer.read(found[0]), Z_UP_FROM_Y_UP


def _named_part(path: Path, item: str) -> trimesh.Trimesh:
    """One thing of a glTF file that holds several, where it stands by itself."""
    check_header(path)
    try:
        scene = trimesh.load_scene(path, file_type="gltf", process=False)
    except Exception as error:
        # The parser meets foreign bytes here and may raise anything; the cause stays attached.
        raise BadMesh(path, f"can't be parsed ({error})", f"{EXPORT_AGAIN}.") from error
    if item not in scene.graph.nodes_geometry:
        raise BadMesh(path, f"holds no {item}", _AGAIN)
    return cast(trimesh.Trimesh, scene.geometry[cast(Any, scene.graph)[item][1]])


def _kept(image: Image.Image, size: tuple[int, int]) -> Image.Image:
    """The texture in its size, as a JPEG: so the exporter embeds it as one, too."""
    image = image.convert("RGB")
    if image.size != size:
        image = image.resize(size, Image.Resampling.LANCZOS)
    content = io.BytesIO()
    image.save(content, "JPEG", quality=_QUALITY)
    return Image.open(io.BytesIO(content.getvalue()))
