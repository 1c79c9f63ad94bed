"""A thing that decides must be told from the other candidates by what shows of it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from boxes import BoxLibrary, box_library, standing
from probe.assets.mesh.mesh import Body, ConvexPiece, TexturedMesh
from probe.assets.tables import table_ids
from probe.generation.look_alikes import look_alike
from probe.tasks.suite_file import packaged_suite
from probe.tasks.task import Task

SIZE = (0.06, 0.05, 0.04)
LIBRARY = box_library(
    red_block=(*SIZE, 190, 40, 40),
    blue_block=(*SIZE, 40, 60, 190),
    dull_block=(*SIZE, 180, 45, 45),
    red_plank=(0.09, 0.05, 0.04, 190, 40, 40),
    green_lid=(0.1, 0.1, 0.05, 40, 150, 60),
)
IDS = {entry.name: entry.id for entry in LIBRARY.specs}


def asked_about(*candidates: str, version=3) -> Task:
    """A task that a red block decides, among some candidates."""
    frozen = packaged_suite("demo").tasks[0]
    scene = standing(LIBRARY, ("red_block", 0.0, 0.0, 0.0), ("green_lid", 0.1, 0.1, 0.0))
    proof = replace(frozen.certificate, candidates=tuple(IDS.get(it, it) for it in candidates))
    return replace(
        frozen,
        version=version,
        scene=replace(scene, table=table_ids(None)[0]),
        targets=(1,),
        certificate=proof,
    )


@pytest.mark.parametrize("others", [("blue block",), ("red plank",), ("blue block", "red plank")])
def test_another_colour_or_outline_tells(renderer, others):
    assert look_alike(asked_about("red block", *others), LIBRARY, renderer) is None


def test_a_shade_does_not(renderer):
    found = look_alike(asked_about("blue block", "dull block", "red block"), LIBRARY, renderer)
    assert found == "what shows of red block is like what would show of dull block"


def test_what_has_another_colour_beneath_only_does_not(renderer):
    """As cans have: from above, all that shows of them is a lid."""
    library = with_another_underside("blue block", of="red block")
    found = look_alike(asked_about("red block", "blue block"), library, renderer)
    assert found is not None and found.endswith("like what would show of blue block")


@pytest.mark.parametrize(
    "task",
    [
        asked_about("red block", "dull block", version=2),
        asked_about("blue block", "dull block"),
        asked_about("0", "1", "2"),
        asked_about("red block"),
    ],
    ids=["of earlier rules", "no candidate decides", "numbers", "nothing to take it for"],
)
def test_where_there_is_nothing_to_compare_nothing_is_found(renderer, task):
    assert look_alike(task, LIBRARY, renderer) is None


def with_another_underside(name: str, of: str) -> BoxLibrary:
    """A library in which a block is as another one, but for the colour of its underside."""
    blue, red = (LIBRARY.bodies[IDS[it]].mesh for it in (name, of))
    texture = np.concatenate([red.surface.texture, blue.surface.texture], axis=1)
    beneath = red.normals[:, 2] < -0.5
    uvs = np.stack([np.where(beneath, 0.75, 0.25), np.full(len(beneath), 0.5)], axis=1)
    surface = replace(red.surface, texture=texture)
    mesh = TexturedMesh(red.vertices, red.normals, uvs.astype(np.float32), red.faces, surface)
    changed = Body(mesh, (ConvexPiece(mesh.vertices.astype(float)),))
    return replace(LIBRARY, bodies={**LIBRARY.bodies, IDS[name]: changed})
