"""Refuse a glTF tree that asks for too much or runs in circles. Reads no file."""

from __future__ import annotations

from collections import Counter
from pathlib import Path
from typing import Any

from probe.assets.mesh.shaping import EXPORT_AGAIN
from probe.errors import BadMesh

MAX_TRIANGLES = 2_000_000
MAX_VERTICES = 3 * MAX_TRIANGLES
MAX_VALUES = 20 * MAX_VERTICES
"""Elements of all accessors together: positions, indices and a dozen further attributes."""

MAX_NODES = 10_000
TRIANGLES = 4


def check_counts(path: Path, tree: dict[str, Any]) -> None:
    """Refuse more triangles, vertices or values than any object needs.

    Raises:
        BadMesh: Too many, or accessors that can't be understood.
    """
    try:
        triangles, vertices = _counts(tree)
        values = sum(int(accessor["count"]) for accessor in tree.get("accessors", []))
    except (TypeError, KeyError, IndexError, ValueError, AttributeError, OverflowError) as error:
        raise BadMesh(path, "its accessors are malformed", f"{EXPORT_AGAIN}.") from error
    if triangles > MAX_TRIANGLES or vertices > MAX_VERTICES:
        reason = f"has {triangles:,} triangles and {vertices:,} vertices"
        remedy = f"Decimate it to at most {MAX_TRIANGLES:,} triangles (20,000 are plenty)."
        raise BadMesh(path, reason, remedy)
    if values > MAX_VALUES:
        raise BadMesh(path, f"its accessors claim {values:,} values", f"{EXPORT_AGAIN}.")


def check_nodes(path: Path, tree: dict[str, Any]) -> None:
    """Refuse nodes that aren't strict trees (glTF 2.0, "Nodes and Hierarchy"), or too many.

    Raises:
        BadMesh: A node has two parents, is its own ancestor, or there are over 10,000.
    """
    nodes = tree.get("nodes", [])
    try:
        children = [[int(child) for child in node.get("children", [])] for node in nodes]
        parents = [0] * len(children)
        for child in (child for family in children for child in family):
            parents[child if child >= 0 else len(parents)] += 1
    except (TypeError, ValueError, IndexError, AttributeError, OverflowError) as error:
        raise BadMesh(path, "its nodes are malformed", f"{EXPORT_AGAIN}.") from error
    if len(children) > MAX_NODES:
        raise BadMesh(path, f"has {len(children):,} nodes", "Join its parts into one mesh.")
    if max(parents, default=0) > 1:
        raise BadMesh(path, f"node {parents.index(max(parents))} has two parents", _APPLY)
    if _reached(children, parents) < len(children):
        raise BadMesh(path, "its nodes run in a circle", _APPLY)


_APPLY = "Apply all transforms and join the parts in a mesh editor, then export again."


def _reached(children: list[list[int]], parents: list[int]) -> int:
    """How many nodes one gets to from those without a parent."""
    waiting = [node for node, count in enumerate(parents) if count == 0]
    reached = 0
    while waiting:
        reached += 1
        waiting += children[waiting.pop()]
    return reached


def _counts(tree: dict[str, Any]) -> tuple[int, int]:
    """Triangles and vertices over all meshes, each as often as a node shows it."""
    accessors = tree.get("accessors", [])
    shown = Counter(str(node.get("mesh")) for node in tree.get("nodes", []))
    triangles = vertices = 0
    for number, mesh in enumerate(tree.get("meshes", [])):
        times = max(1, shown[str(number)])
        for primitive in mesh["primitives"]:
            if primitive.get("mode", TRIANGLES) < TRIANGLES:
                continue
            corners = int(accessors[primitive["attributes"]["POSITION"]]["count"])
            vertices += times * corners
            if "indices" in primitive:
                corners = int(accessors[primitive["indices"]]["count"])
            strip = primitive.get("mode", TRIANGLES) != TRIANGLES
            triangles += times * (corners if strip else corners // 3)
    return triangles, vertices
