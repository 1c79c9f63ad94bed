"""Small data sets in the layouts that we import, written by formula."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import trimesh
from PIL import Image

MTL = "newmtl skin\nKd 1 1 1\nmap_Kd texture.png\n"
SDF = """<?xml version="1.0"?>
<!-- Creative Commons Attribution 4.0 International License -->
<sdf version="1.6"><model name="Box"><link name="link">
<visual name="visual"><geometry><mesh><uri>model://Box/meshes/model.obj</uri></mesh></geometry>
</visual><inertial><mass>0.25</mass></inertial></link></model></sdf>
"""


def box(size=(0.1, 0.06, 0.04)) -> trimesh.Trimesh:
    """A box off its origin."""
    return trimesh.creation.box(size).apply_translation((0.3, -0.2, 0.1))


def picture(path: Path, colour=(200, 30, 30)) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    Image.new("RGB", (8, 8), colour).save(path)
    return path


def obj_text(mesh: trimesh.Trimesh, library: str = "model.mtl", material: str = "skin") -> str:
    lines = [f"mtllib {library}", *(f"v {x:.6f} {y:.6f} {z:.6f}" for x, y, z in mesh.vertices)]
    lines += ["vt 0 0", "vt 1 0", "vt 0 1", f"usemtl {material}"]
    lines += [f"f {a + 1}/1 {b + 1}/2 {c + 1}/3" for a, b, c in mesh.faces]
    return "\n".join(lines) + "\n"


def obj_folder(folder: Path, mesh: trimesh.Trimesh | None = None, mtl: str = MTL) -> Path:
    """model.obj, its material and its texture in one folder; the OBJ's path."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "model.mtl").write_text(mtl)
    picture(folder / "texture.png")
    path = folder / "model.obj"
    path.write_text(obj_text(mesh or box()))
    return path


def gso_folder(folder: Path, mesh: trimesh.Trimesh | None = None) -> Path:
    """A Gazebo folder whose texture is not beside its material."""
    obj_folder(folder / "meshes", mesh)
    (folder / "meshes" / "texture.png").unlink()
    picture(folder / "materials" / "textures" / "texture.png")
    (folder / "model.sdf").write_text(SDF)
    (folder / "metadata.pbtxt").write_text('categories {\n  first: "Action Figures"\n}\n')
    return folder


def ply_bytes(mesh: trimesh.Trimesh, texture: str = "obj_000001.png") -> bytes:
    """An ASCII PLY with texture coordinates, as BOP has them."""
    head = ["ply", "format ascii 1.0", f"comment TextureFile {texture}"]
    head += [f"element vertex {len(mesh.vertices)}"]
    head += [f"property float {name}" for name in ("x", "y", "z", "texture_u", "texture_v")]
    head += [f"element face {len(mesh.faces)}", "property list uchar int vertex_indices"]
    rows = [" ".join(f"{v:.5f}" for v in (*place, 0.5, 0.5)) for place in mesh.vertices]
    rows += ["3 " + " ".join(map(str, face)) for face in mesh.faces]
    return "\n".join([*head, "end_header", *rows, ""]).encode()


def bop_set(folder: Path, mesh: trimesh.Trimesh | None = None, **more: object) -> Path:
    """A set of one model, in millimetres; `more` goes into its models_info.json."""
    models = folder / "toy" / "models"
    models.mkdir(parents=True)
    large = (mesh or box()).copy()
    large.apply_scale(1000)
    (models / "obj_000001.ply").write_bytes(ply_bytes(large))
    picture(models / "obj_000001.png")
    extent = np.ptp(large.vertices, axis=0)
    sizes = {f"size_{axis}": float(extent[i]) for i, axis in enumerate("xyz")}
    (models / "models_info.json").write_text(json.dumps({"1": {"diameter": 1.0, **sizes, **more}}))
    return folder
