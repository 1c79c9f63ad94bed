"""What the table is covered with: textures from disk, and some drawn by formula."""

from __future__ import annotations

import hashlib
import io
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path

import numpy as np
from PIL import Image

from probe.assets.cache import Cache, content_key
from probe.assets.looks import Looks
from probe.assets.mesh.mesh import Material
from probe.assets.recipes import recipe
from probe.assets.tabletops import paint_worn, tops
from probe.assets.tabletops.noise import normals_of
from probe.errors import BadData, UnknownName
from probe.reading import MESH, contents
from probe.types import Array

TILE_SIZES = {
    "AcousticFoam": 0.5,
    "Fabric": 0.4,
    "Leather": 0.5,
    "Metal": 0.6,
    "PHRosewoodVeneer": 0.6,
    "Sponge": 0.3,
    "Tiles": 1.2,
    "Wood": 0.8,
}
"""Metres that a texture's edge covers, by the letters its name begins with; estimated.

AmbientCG seldom says; where it does, 1 m is usual.
"""
USUAL_TILE_SIZE = 1.0
_LARGEST_PX = 16_384


@dataclass(frozen=True, eq=False)
class TableMaterial:
    """What a table top is made of.

    Attributes:
        id: "oak_planks", or for a texture on disk its name, "Wood027".
        texture: Base colour in sRGB, uint8, shape (h, w, 3); seamless.
        tile_size: Metres along an edge of one repeat.
        roughness: 0 (mirror) to 1 (chalk), a mean where there is a map.
        normal: Normal map in the OpenGL convention (green up), uint8, shape (h, w, 3), or None.
        metallic: 0, or 1 for bare metal.
        roughness_map: Roughness times 255, uint8, shape (h, w), or None.
    """

    id: str
    texture: Array
    tile_size: float
    roughness: float
    normal: Array | None
    metallic: float = 0.0
    roughness_map: Array | None = None

    @property
    def surface(self) -> Material:
        """How it takes light, as a mesh has it."""
        return Material(
            self.texture, self.roughness, self.metallic, self.normal, self.roughness_map
        )


def table_ids(assets: Path | None) -> tuple[str, ...]:
    """All table materials: those drawn by formula, then those in the extra assets.

    The latter are whatever lies there, odd tables (foam, paving stones) included.
    """
    painted = tuple(tops())
    folder = None if assets is None else assets / "textures"
    if folder is None or not folder.is_dir():
        return painted
    names = sorted(entry.name.split("_")[0] for entry in folder.iterdir() if entry.is_dir())
    return (*painted, *names)


@lru_cache(maxsize=4)
def load_table(
    id: str, assets: Path | None, cache: Cache | None = None, looks: Looks = 1
) -> TableMaterial:
    """A table material by id; those drawn by formula take half a second the first time.

    Args:
        id: Which.
        assets: Folder of extra assets; None if only those drawn by formula are wanted.
        cache: Keeps what is drawn by formula; None to draw it each time.
        looks: How one that is drawn by formula looks.

    Raises:
        UnknownName: No material has this id.
        BadData: Its files are broken.
        OutputFailed: The cache can't be written.
    """
    if id in tops():
        return _painted(id, cache, looks)
    known = table_ids(assets)
    if assets is None or id not in known:
        folder = "the folder that PROBE_ASSETS names" if assets is None else str(assets)
        remedy = f"A photographed one has to be among the textures of {folder}."
        raise UnknownName("table", id, list(known), remedy)
    return _photographed(id, assets / "textures")


def _painted(id: str, cache: Cache | None, looks: Looks) -> TableMaterial:
    key = content_key("table top", recipe("probe.assets.tabletops"), id, str(looks))
    stored = cache.load(key) if cache else None
    if stored is not None:
        tile, rough, metallic = (float(value) for value in stored["numbers"])
        rough_map = stored.get("roughness_map")
        return TableMaterial(
            id, stored["texture"], tile, rough, stored["normal"], metallic, rough_map
        )
    made = _paint(id, looks)
    if cache:
        numbers = np.array([made.tile_size, made.roughness, made.metallic])
        assert made.normal is not None
        maps = {} if made.roughness_map is None else {"roughness_map": made.roughness_map}
        pictures = {"texture": made.texture, "normal": made.normal}
        cache.store(key, pictures | maps | {"numbers": numbers})
    return made


def _paint(id: str, looks: Looks) -> TableMaterial:
    rng = np.random.default_rng(int.from_bytes(hashlib.sha256(id.encode()).digest()[:8], "big"))
    sheet = tops()[id].paint(rng) if looks == 1 else paint_worn(tops()[id], rng)
    texture = np.clip(np.round(sheet.colour), 0, 255).astype(np.uint8)
    normal = normals_of(sheet.height, sheet.tile_size / len(sheet.height))
    rough = sheet.roughness_map
    bytes_ = None if rough is None else np.round(255 * rough).astype(np.uint8)
    return TableMaterial(
        id, texture, sheet.tile_size, sheet.roughness, normal, sheet.metallic, bytes_
    )


def _photographed(id: str, textures: Path) -> TableMaterial:
    """A folder in AmbientCG's naming; of its maps only the colour has to be there."""
    folder = next(f for f in sorted(textures.iterdir()) if f.name.split("_")[0] == id)
    texture = _map(folder, "Color")
    if texture is None:
        remedy = "Unpack the material again: *_Color.jpg or .png is needed."
        raise BadData(folder, "has no colour map", remedy)
    return TableMaterial(
        id,
        texture,
        _tile_size(id),
        _mean(_map(folder, "Roughness"), otherwise=0.6),
        _normals(folder),
        round(_mean(_map(folder, "Metalness"), otherwise=0.0)),
        _grey(_map(folder, "Roughness")),
    )


def _normals(folder: Path) -> Array | None:
    """Normals with green up; a map in DirectX's convention is turned over."""
    normal = _map(folder, "NormalGL")
    if normal is not None:
        return normal
    turned = _map(folder, "NormalDX")
    if turned is None:
        return None
    turned = turned.copy()
    turned[..., 1] = 255 - turned[..., 1]
    return turned


def _mean(map: Array | None, otherwise: float) -> float:
    return otherwise if map is None else float(map.mean()) / 255


def _grey(map: Array | None) -> Array | None:
    return None if map is None else np.ascontiguousarray(map[..., 0])


def _map(folder: Path, kind: str) -> Array | None:
    """A map as uint8, shape (h, w, 3); None if the material has none of this kind."""
    files = sorted(f for f in folder.glob(f"*_{kind}.*") if f.suffix in {".jpg", ".png"})
    if not files:
        return None
    try:
        content = io.BytesIO(contents(files[0], MESH))
        with Image.open(content, formats=("JPEG", "PNG")) as image:
            if max(image.size) > _LARGEST_PX:
                raise ValueError(f"it has {image.width} x {image.height} pixels")
            return np.asarray(image.convert("RGB"), dtype=np.uint8)
    except (OSError, ValueError, SyntaxError, Image.DecompressionBombError) as error:
        remedy = "Unpack the material again."
        raise BadData(files[0], f"can't be read ({error})", remedy) from error


def _tile_size(id: str) -> float:
    fitting = [prefix for prefix in TILE_SIZES if id.startswith(prefix)]
    return TILE_SIZES[max(fitting, key=len)] if fitting else USUAL_TILE_SIZE
