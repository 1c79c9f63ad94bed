"""The catalogue's scans written anew in the layouts in which other people's objects come."""

from __future__ import annotations

import csv
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from PIL import Image

from probe.assets.gltf.glb import Z_UP_FROM_Y_UP, read_gltf
from probe.types import Array

SDF = """<?xml version="1.0"?>
<!-- Creative Commons Attribution 4.0 International License -->
<sdf version="1.6"><model name="{name}"><link name="link"><visual name="visual"><geometry><mesh>
<uri>model://{name}/meshes/model.obj</uri></mesh></geometry></visual>
<inertial><mass>{mass}</mass></inertial></link></model></sdf>
"""
URDF = """<robot name="{name}"><link name="base"><inertial><mass value="{mass}"/></inertial>
<visual><geometry><mesh filename="package://{name}/visual/{name}.obj"/></geometry></visual>
</link></robot>
"""
MJCF = """<mujoco><asset><mesh name="model" file="model.obj"/></asset><worldbody><body>
<inertial pos="0 0 0" mass="{mass}" diaginertia="1 1 1"/><geom type="mesh" mesh="model"/>
</body></worldbody></mujoco>
"""


@dataclass(frozen=True)
class Scan:
    """A scan as it is to be written.

    Attributes:
        id: In the catalogue.
        name: As its source called it.
        number: Within the benchmark; for YCB's numbers in folder names.
        mass: Kilograms, by the catalogue.
        vertices: z up, metres, shape (n, 3).
        uv: Shape (n, 2), v from the bottom.
        faces: Shape (m, 3).
        texture: The picture.
    """

    id: str
    name: str
    number: int
    mass: float
    vertices: Array
    uv: Array
    faces: Array
    texture: Image.Image


@dataclass(frozen=True)
class Layout:
    """One way of laying objects out.

    Attributes:
        write: Writes a scan below a folder.
        format: As which it is added.
        states_mass: Whether a file beside the mesh states the mass.
    """

    write: Callable[[Path, Scan], None]
    format: str
    states_mass: bool = False


def read_scan(folder: Path, object_id: str, name: str, number: int, mass: float) -> Scan:
    """A scan of the catalogue, z up."""
    part = read_gltf(folder / f"{object_id}.glb")
    vertices = np.asarray(part.vertices) @ Z_UP_FROM_Y_UP.T
    uv = np.asarray(part.visual.uv)  # pyright: ignore
    material = part.visual.material  # pyright: ignore
    picture = getattr(material, "baseColorTexture", None) or material.image
    assert picture is not None, object_id
    texture = picture.convert("RGB")
    return Scan(object_id, name, number, mass, vertices, uv, np.asarray(part.faces), texture)


def original_names(folder: Path) -> dict[str, str]:
    """What the sources called their objects, by our ids; YCB's with their numbers in front."""
    with (folder / "index.csv").open(newline="") as file:
        return {
            row["id"]: _original(row["id"], row["original_name"]) for row in csv.DictReader(file)
        }


def _original(object_id: str, name: str) -> str:
    if not object_id.startswith("ycb_") or name[0].isdigit():
        return name
    return f"{object_id.split('_')[1]}{'-' if name[1] == '_' else '_'}{name}"


def _obj(
    path: Path, scan: Scan, library: str | None, scale: float = 1.0, turned: bool = False
) -> None:
    """The OBJ alone; `turned` writes it y up."""
    points = scan.vertices @ Z_UP_FROM_Y_UP if turned else scan.vertices
    lines = [f"mtllib {library}"] if library else []
    lines += [f"v {x:.6f} {y:.6f} {z:.6f}" for x, y, z in scale * points]
    lines += [f"vt {u:.6f} {v:.6f}" for u, v in scan.uv]
    lines += ["usemtl material_0"] if library else []
    lines += [f"f {a}/{a} {b}/{b} {c}/{c}" for a, b, c in scan.faces + 1]
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("\n".join(lines) + "\n")


def _skin(path: Path, scan: Scan) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    scan.texture.save(path)


def _mtl(path: Path, texture: str) -> None:
    path.write_text(f"newmtl material_0\nKd 1 1 1\nmap_Kd {texture}\n")


def _ycb(folder: Path, scan: Scan) -> None:
    """YCB's: several reconstructions, one of them good, in folders that say nothing."""
    home = folder / (scan.name if scan.name[0].isdigit() else f"{scan.number:03d}_{scan.name}")
    for kind in ("google_16k", "tsdf"):
        _obj(home / kind / "textured.obj", scan, "textured.mtl")
        _mtl(home / kind / "textured.mtl", "texture_map.png")
        _skin(home / kind / "texture_map.png", scan)
    _obj(home / "google_16k" / "nontextured.obj", scan, None)
    _obj(home / "poisson" / "nontextured.obj", scan, None)


def _ycb_bare(folder: Path, scan: Scan) -> None:
    """YCB's meshes as some copies have them: no material file, or one that names nothing there."""
    home = folder / scan.name
    _obj(home / "textured.obj", scan, "textured.obj.mtl")
    if scan.number % 2:
        _mtl(home / "textured.obj.mtl", "textured_0.png")
    _skin(home / "texture_map.png", scan)


def _gazebo(folder: Path, scan: Scan) -> None:
    """Google Scanned Objects as Fuel hands them out."""
    home = folder / scan.name
    _aloha(folder, scan)
    _mtl(home / "meshes" / "model.mtl", "texture.png")
    (home / "model.sdf").write_text(SDF.format(name=scan.name, mass=scan.mass))


def _aloha(folder: Path, scan: Scan) -> None:
    """Google Scanned Objects inside other projects: no model.sdf, no material file."""
    home = folder / scan.name
    _obj(home / "meshes" / "model.obj", scan, "model.mtl")
    _skin(home / "materials" / "textures" / "texture.png", scan)


def _urdf(folder: Path, scan: Scan) -> None:
    """A URDF package with visual and collision meshes."""
    home = folder / scan.name
    _obj(home / "visual" / f"{scan.name}.obj", scan, "material.mtl")
    _mtl(home / "visual" / "material.mtl", "../textures/skin.png")
    _skin(home / "textures" / "skin.png", scan)
    _obj(home / "collision" / f"{scan.name}_vhacd.obj", scan, None)
    (home / f"{scan.name}.urdf").write_text(URDF.format(name=scan.name, mass=scan.mass))


def _mujoco(folder: Path, scan: Scan) -> None:
    """As for MuJoCo: pieces for collisions beside the mesh, the mass in model.xml."""
    home = folder / scan.name
    _obj(home / "model.obj", scan, None)
    _skin(home / "texture.png", scan)
    for number in range(2):
        _obj(home / f"model_collision_{number}.obj", scan, None)
    (home / "model.xml").write_text(MJCF.format(mass=scan.mass))


def _table(folder: Path, scan: Scan) -> None:
    """Plain OBJ folders, y up, with a collision mesh each; masses in one table, in grams."""
    home = folder / scan.name
    _obj(home / "model.obj", scan, "model.mtl", turned=True)
    _obj(home / "model_coll.obj", scan, None, turned=True)
    _mtl(home / "model.mtl", "texture.png")
    _skin(home / "texture.png", scan)
    table = folder / "masses.csv"
    rows = table.read_text() if table.exists() else "object,mass (g)\n"
    table.write_text(f"{rows}{scan.name},{1000 * scan.mass:g}\n")


def _plain(folder: Path, scan: Scan) -> None:
    """Scans by name in one folder, z up, each with its own material."""
    _obj(folder / f"{scan.name}.obj", scan, f"{scan.name}.mtl")
    _mtl(folder / f"{scan.name}.mtl", f"{scan.name}.png")
    _skin(folder / f"{scan.name}.png", scan)


LAYOUTS: dict[str, Layout] = {
    "ycb": Layout(_ycb, "obj"),
    "ycb bare": Layout(_ycb_bare, "obj"),
    "gazebo": Layout(_gazebo, "gso", states_mass=True),
    "aloha": Layout(_aloha, "gso"),
    "scalingup": Layout(_aloha, "obj"),
    "urdf": Layout(_urdf, "obj", states_mass=True),
    "mujoco": Layout(_mujoco, "obj", states_mass=True),
    "table": Layout(_table, "obj", states_mass=True),
    "plain": Layout(_plain, "obj"),
}
