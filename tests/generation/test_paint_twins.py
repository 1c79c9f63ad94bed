"""Of one shape, of different paint, and alike on a side."""

from __future__ import annotations

from dataclasses import replace
from types import SimpleNamespace
from typing import cast

import numpy as np
import pytest
import trimesh

from probe.assets.colour.names import lab
from probe.assets.library import Library
from probe.assets.mesh.lattice import spots
from probe.assets.mesh.mesh import Material, TexturedMesh
from probe.generation.paint_twins import alike, paint_twins
from tabletops import spec

RED, BLUE, WHITE = (200, 30, 30), (30, 30, 200), (240, 240, 240)


def painted(body: tuple[int, int, int], cap: tuple[int, int, int], length: float = 0.12):
    """A bar along x, 2 cm high; its last quarter towards +x is the cap."""
    box = trimesh.creation.box((length, 0.03, 0.02))
    vertices, faces, *_ = trimesh.remesh.subdivide_to_size(box.vertices, box.faces, 0.01)
    vertices = vertices + (0, 0, 0.01)
    along = vertices[:, 0] / length + 0.5
    uvs = np.column_stack([along, np.full(len(along), 0.5)]).clip(0.001, 0.999)
    texture = np.array([[body] * 3 + [cap]], dtype=np.uint8)
    return TexturedMesh(vertices, np.zeros_like(vertices), uvs, faces, Material(texture))


def bar(name: str, colour: str):
    return replace(spec(name, colour), category="bar", size=(0.12, 0.03, 0.02))


def library(meshes: dict[str, TexturedMesh]) -> Library:
    bodies = {name: SimpleNamespace(mesh=mesh) for name, mesh in meshes.items()}
    return cast(Library, SimpleNamespace(body=bodies.__getitem__))


def twins(*bars: tuple[str, str, TexturedMesh]):
    specs = [bar(name, colour) for name, colour, _ in bars]
    meshes = {one.id: mesh for one, (*_, mesh) in zip(specs, bars, strict=True)}
    return paint_twins(library(meshes), specs)


def test_the_cap_is_the_side_on_which_they_are_alike():
    (found,) = twins(
        ("red bar", "red", painted(RED, WHITE)), ("blue bar", "blue", painted(BLUE, WHITE))
    )
    assert [each.name for each in found.pair] == ["red bar", "blue bar"]
    assert 0 in found.angles and np.cos(found.angles).min() > 0.45
    assert np.abs(found.patches - lab(np.array([WHITE]))).max() < 1


@pytest.mark.parametrize(
    "other",
    [
        ("blue bar", "blue", painted(BLUE, BLUE)),
        ("blue bar", "blue", painted(BLUE, WHITE, length=0.13)),
        ("bright red bar", "red", painted(BLUE, WHITE)),
    ],
    ids=["no cap", "longer", "of the same name"],
)
def test_others_are_no_twins(other):
    assert twins(("red bar", "red", painted(RED, WHITE)), other) == ()


def test_paint_is_compared_spot_by_spot():
    red, blue = painted(RED, WHITE), painted(BLUE, WHITE)
    face, weights = spots(red.vertices, red.faces, 4000)
    share = alike(red, blue, face, weights).mean()
    # A quarter of four long sides of 0.12 x 0.03 and 0.12 x 0.02, and one end of 0.03 x 0.02.
    whole = 2 * 0.12 * (0.03 + 0.02) + 2 * 0.03 * 0.02
    assert share == pytest.approx((0.03 * 2 * (0.03 + 0.02) + 0.03 * 0.02) / whole, abs=0.01)
    assert alike(red, red, face, weights).all()
