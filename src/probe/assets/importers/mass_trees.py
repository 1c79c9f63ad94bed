"""Masses in URDF, SDF and MJCF files. Entities, how XML explodes, are refused."""

from __future__ import annotations

import re
from pathlib import Path
from xml.etree import ElementTree

from probe.assets.importers.wording import says_nothing
from probe.errors import BadData

TREES = (".urdf", ".sdf", ".xml", ".mjcf")
MAX_BYTES = 2**20
_DOCTYPE = re.compile(r"<!(DOCTYPE|ENTITY)", re.I)
_SCHEME = re.compile(r"^(?:package|model|file)://[^/]*/?")
_REMEDY = "Correct it, or state the mass in a CSV table"


def masses_in_tree(path: Path, mesh: Path, home: Path) -> list[float]:
    """Kilograms of the links or bodies that a mesh belongs to; or of the only one that there is.

    Args:
        path: URDF, SDF or MJCF; other XML says nothing.
        mesh: Whose mass is asked for.
        home: The object's folder; a file in it with a single body is about it if it bears its
            name, or if the mesh bears none.

    Raises:
        BadData: It can't be read, is no XML, defines entities, or states a mass that is no number.
    """
    tree = parsed(path)
    if tree.tag == "mujoco":
        bodies, stated = list(tree.iter("body")), _of_body
        files = _mesh_files(tree)
    else:
        bodies, stated = list(tree.iter("link")), _of_link
        files = {}
    heavy = [(body, mass) for body in bodies if (mass := stated(path, body)) is not None]
    named = [mass for body, mass in heavy if any(_is(mesh, name) for name in _names(body, files))]
    about = says_nothing(mesh.stem) or path.stem in (mesh.stem, home.name)
    return named or ([mass for _, mass in heavy] if about and len(heavy) == 1 else [])


def parsed(path: Path) -> ElementTree.Element:
    """The root element of an XML file.

    Raises:
        BadData: It can't be read, is too large or no XML, or defines entities.
    """
    try:
        with path.open("rb") as file:
            raw = file.read(MAX_BYTES + 1)
    except OSError as error:
        raise BadData(path, error.strerror or "can't be read", _REMEDY) from error
    if len(raw) > MAX_BYTES:
        raise BadData(path, f"has over {MAX_BYTES / 2**20:.0f} MB", _REMEDY)
    text = raw.decode("utf-8-sig", "replace").replace("\x00", "")
    if _DOCTYPE.search(text):
        raise BadData(path, "defines entities", _REMEDY)
    try:
        return ElementTree.fromstring(text.lstrip())
    except (ElementTree.ParseError, ValueError) as error:
        raise BadData(path, f"is no XML ({error})", _REMEDY) from error


def _of_link(path: Path, link: ElementTree.Element) -> float | None:
    """Mass of a URDF's link (``<mass value="0.2"/>``) or an SDF's (``<mass>0.2</mass>``)."""
    found = link.find("inertial/mass")
    return None if found is None else _number(path, found.get("value") or found.text)


def _of_body(path: Path, body: ElementTree.Element) -> float | None:
    """Mass of an MJCF's body: as stated, else the sum of its parts'."""
    inertial = body.find("inertial")
    if inertial is not None and inertial.get("mass"):
        return _number(path, inertial.get("mass"))
    parts = [geom.get("mass") for geom in body.iter("geom") if geom.get("mass")]
    return sum(_number(path, part) for part in parts) if parts else None


def _number(path: Path, text: str | None) -> float:
    try:
        return float(text or "")
    except ValueError as error:
        raise BadData(path, f"states a mass of {(text or '')[:40]!r}", _REMEDY) from error


def _mesh_files(tree: ElementTree.Element) -> dict[str, str]:
    """The files of an MJCF's meshes, by the names that its parts use."""
    files = [(mesh.get("name"), mesh.get("file", "")) for mesh in tree.iterfind("asset/mesh")]
    return {name or Path(file).stem: file for name, file in files}


def _names(body: ElementTree.Element, files: dict[str, str]) -> list[str]:
    """The mesh files that a link or body shows."""
    urdf = [mesh.get("filename", "") for mesh in body.iter("mesh")]
    sdf = [uri.text or "" for uri in body.iterfind(".//mesh/uri")]
    mjcf = [files.get(geom.get("mesh", ""), "") for geom in body.iter("geom")]
    return [name for name in (*urdf, *sdf, *mjcf) if name]


def _is(mesh: Path, name: str) -> bool:
    """Whether a reference is to this mesh: its last parts are the same."""
    parts = [part for part in _SCHEME.sub("", name.strip()).replace("\\", "/").split("/") if part]
    parts = [part for part in parts if part not in (".", "..")]
    return bool(parts) and mesh.parts[-len(parts) :] == tuple(parts)
