"""Meshes that break their formats, for `probe assets add`; and whole ones, which it must take."""

from __future__ import annotations

import json
import struct
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
import trimesh
from command import refusal
from PIL import Image
from trimesh.visual import TextureVisuals
from trimesh.visual.material import PBRMaterial, SimpleMaterial
from verdict import Attack, some

KIND = "mesh files"
_SIZE = 0.08

Spoil = Callable[[bytes], bytes]


def attack_meshes(folder: Path, scale: float) -> Iterator[Attack]:
    """Add a whole mesh of each format, then spoilt ones.

    Args:
        folder: For the meshes and a library.
        scale: The share of spoilt ones that is tried.
    """
    for form, suffix, spoilt in (("obj", "obj", _OBJ), ("gltf", "glb", _GLTF)):
        yield _whole(folder, form, suffix)
        for number, (name, spoil) in enumerate(some(list(spoilt.items()), scale)):
            home = folder / f"{form}_{number}"
            file = _box(home, suffix)
            file.write_bytes(spoil(file.read_bytes()))
            attack = _added(folder, f"{form}: {name}", form, home)
            # A folder of objects says of each what is wrong with it, and goes on.
            told = attack.verdict == "read wrongly" and "0 added" in attack.detail
            yield Attack(KIND, attack.name, "refused", attack.detail) if told else attack


def _whole(folder: Path, form: str, suffix: str) -> Attack:
    home = folder / f"{form}_whole"
    _box(home, suffix)
    attack = _added(folder, f"{form}: a whole one", form, home)
    taken = attack.verdict == "read wrongly" and "1 added" in attack.detail
    # Were it refused, what becomes of the spoilt ones would say nothing.
    return Attack(KIND, attack.name, "harmless" if taken else "crashed", attack.detail)


def _added(folder: Path, name: str, form: str, home: Path) -> Attack:
    words = ("assets", "add", form, home, "--licence", "CC0-1.0", "--source", "nobody")
    library = {"PROBE_LIBRARY": str(folder / f"library_{home.name}")}
    return refusal(KIND, name, *words, patience=120, environment=library)


def _box(home: Path, suffix: str) -> Path:
    """A painted box in a folder of its own."""
    rng = np.random.default_rng(len(suffix))
    box = trimesh.creation.box((_SIZE, 0.7 * _SIZE, 0.5 * _SIZE))
    box.unmerge_vertices()
    uvs = rng.uniform(0.1, 0.9, (len(box.vertices), 2))
    paint = Image.fromarray(rng.integers(60, 200, (32, 32, 3), dtype=np.uint8))
    glb = suffix == "glb"
    material = PBRMaterial(baseColorTexture=paint) if glb else SimpleMaterial(image=paint)
    box.visual = TextureVisuals(uv=uvs, material=material)
    home.mkdir(parents=True)
    file = home / f"box.{suffix}"
    box.export(file)
    return file


def _more(line: str) -> Spoil:
    return lambda content: content + f"\n{line}\n".encode()


_OBJ: dict[str, Spoil] = {
    "index 0": _more("f 0/1/1 1/1/1 2/2/2"),
    "index 99999": _more("f 1/1/1 2/2/2 99999/1/1"),
    "index -99999": _more("f 1/1/1 2/2/2 -99999/1/1"),
    "texture index 0": _more("f 1/0/1 2/0/2 3/0/3"),
    "no whole number": _more("f 1.5/1/1 2/2/2 3/3/3"),
    "a corner at nan": _more("v nan 0 0\nf 1/1/1 2/2/2 -1/1/1"),
    "a corner at infinity": _more("v inf 0 0\nf 1/1/1 2/2/2 -1/1/1"),
    "a corner without numbers": _more("v a b c\nf 1/1/1 2/2/2 -1/1/1"),
    "empty": lambda _: b"",
    "no text": lambda _: bytes(range(256)) * 9,
    "half of it": lambda content: content[: len(content) // 2],
}


def _tree(change: Callable[[dict[str, Any]], object]) -> Spoil:
    """Change a GLB's JSON."""

    def spoil(content: bytes) -> bytes:
        (length,) = struct.unpack_from("<I", content, 12)
        tree, rest = json.loads(content[20 : 20 + length]), content[20 + length :]
        change(tree)
        text = json.dumps(tree).encode()
        text += b" " * (-len(text) % 4)
        whole = struct.pack("<I4s", len(text), b"JSON") + text + rest
        return struct.pack("<4sII", b"glTF", 2, 12 + len(whole)) + whole

    return spoil


def _node(**more: object) -> Spoil:
    return _tree(lambda tree: tree["nodes"][-1].update(more))


_GLTF: dict[str, Spoil] = {
    "source -1": _tree(lambda tree: tree["textures"][0].update(source=-1)),
    "source 99": _tree(lambda tree: tree["textures"][0].update(source=99)),
    "texture -1": _tree(
        lambda tree: tree["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"].update(
            index=-1
        )
    ),
    "material -1": _tree(lambda tree: tree["meshes"][0]["primitives"][0].update(material=-1)),
    "accessor -1": _tree(
        lambda tree: tree["meshes"][0]["primitives"][0]["attributes"].update(POSITION=-1)
    ),
    "mesh -1": _node(mesh=-1),
    "node -1": _tree(lambda tree: tree["scenes"][0].update(nodes=[-1])),
    "a ring of nodes": _node(children=[0]),
    "zero rotation": _node(rotation=[0, 0, 0, 0]),
    "scale 0": _node(scale=[0, 0, 0]),
    "scale 1e300": _node(scale=[1e300] * 3),
    "a billion corners": _tree(lambda tree: tree["accessors"][0].update(count=10**9)),
    "a view past the end": _tree(lambda tree: tree["bufferViews"][0].update(byteOffset=10**9)),
    "half of it": lambda content: content[: len(content) // 2],
    "no text": lambda _: b"glTF" + bytes(range(256)),
    "empty": lambda _: b"",
}
