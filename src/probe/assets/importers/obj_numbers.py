"""Whether an OBJ's numbers agree: how much there is, and which lines its faces name."""

from __future__ import annotations

import re
from pathlib import Path

from probe.assets.gltf.tree import MAX_TRIANGLES, MAX_VERTICES
from probe.errors import BadMesh

MAX_WORDS = 20 * MAX_TRIANGLES
_STATED = re.compile(rb"^# (Vertices|Faces): (\d+)[ \t\r]*$", re.M)
_FACE = re.compile(rb"^f[ \t]+(.*)$", re.M)
_INDEX = re.compile(rb"[+-]?\d{1,9}")
_LISTS = ("vertex", "texture coordinate", "normal")


def check_counts(path: Path, text: bytes) -> None:
    """Refuse an OBJ that is cut off, has no faces, or has too many.

    Raises:
        BadMesh: It is one of these.
    """
    lines = b"\n" + text
    found = {"Vertices": lines.count(b"\nv "), "Faces": lines.count(b"\nf ")}
    for kind, stated in _STATED.findall(text[:4096]):
        if found[kind.decode()] < int(stated[:12]):
            reason = f"truncated: {found[kind.decode()]:,} of {int(stated[:12]):,} {kind.decode()}"
            raise BadMesh(path, f"{reason.lower()} are there", "Copy or download it again.")
    if not found["Faces"]:
        raise BadMesh(path, "contains no triangles", "Export the model's mesh, not only points.")
    large = found["Faces"] > MAX_TRIANGLES or found["Vertices"] > MAX_VERTICES
    if large or text.count(b" ") > MAX_WORDS:
        reason = f"has {found['Faces']:,} faces and {found['Vertices']:,} vertices"
        remedy = f"Decimate it to at most {MAX_TRIANGLES:,} triangles (20,000 are plenty)."
        raise BadMesh(path, reason, remedy)
    last = text[text.rstrip().rfind(b"\n") + 1 :].split()
    if last[:1] == [b"f"] and len(last) < 4:
        raise BadMesh(path, "truncated: its last face is cut off", "Copy or download it again.")


def check_indices(path: Path, text: bytes) -> None:
    """Refuse corners that are no line of the file: 0, or beyond the last one."""
    lines = b"\n" + text
    there = lines.count(b"\nv "), lines.count(b"\nvt "), lines.count(b"\nvn ")
    for face in _FACE.finditer(text):
        for corner in face[1].split():
            for index, count, name in zip(corner.split(b"/"), there, _LISTS, strict=False):
                if index and not 0 < abs(_index(index)) <= count:
                    line = text.count(b"\n", 0, face.start()) + 1
                    said = index.decode("utf-8", "replace")[:20]
                    reason = f"line {line} names {name} {said} of {count:,}"
                    raise BadMesh(path, reason, "Export the model again as OBJ.")


def _index(raw: bytes) -> int:
    """A number; 0, which nothing has, if it is none."""
    return int(raw) if _INDEX.fullmatch(raw) else 0
