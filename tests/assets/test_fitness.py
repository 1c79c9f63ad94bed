from __future__ import annotations

import numpy as np
import pytest
import trimesh

from probe.assets.fitness import OPENING, holdable, unfit
from probe.assets.mesh.resting import Rest, rest_of
from probe.scene.setup import UR5_TABLE


def _verdict(mesh: trimesh.Trimesh, mass: float = 0.2) -> str | None:
    vertices = np.array(mesh.vertices)
    vertices[:, 2] -= vertices[:, 2].min()
    return unfit(vertices, np.array(mesh.faces), rest_of(vertices), mass)


def _bowl(radius: float, wall: float) -> trimesh.Trimesh:
    """An open cylinder with a floor."""
    outline = [(0, 0), (radius, 0), (radius, 0.08), (radius - wall, 0.08), (radius - wall, wall)]
    return trimesh.creation.revolve([*outline, (0, wall)], sections=48)


def test_the_opening_is_that_of_the_gripper():
    widest = UR5_TABLE.gripper.max_opening
    assert widest - 0.001 < OPENING <= widest


@pytest.mark.parametrize(
    ("mesh", "why"),
    [
        (trimesh.creation.box((0.1, 0.06, 0.04)), None),
        (trimesh.creation.box((0.3, 0.3, 0.03)), "can't be held"),
        (trimesh.creation.box((0.15, 0.15, 0.15)), "can't be held"),
        (trimesh.creation.box((0.3, 0.12, 0.2)), None),
        (trimesh.creation.cylinder(0.07, 0.1), "can't be held"),
        (trimesh.creation.cylinder(0.06, 0.1), None),
        (_bowl(0.1, 0.005), None),
        (trimesh.creation.box((0.5, 0.05, 0.05)), "50.0 cm long"),
        (trimesh.creation.box((0.01, 0.008, 0.008)), "10.0 mm long"),
        (trimesh.creation.icosphere(3, 0.06), None),
        (trimesh.creation.icosphere(3, 0.07), "can't be held"),
    ],
)
def test_what_can_stand_and_be_held(mesh, why):
    verdict = _verdict(mesh)
    assert verdict is None if why is None else verdict is not None and why in verdict


def test_what_is_too_heavy_is_refused():
    assert _verdict(trimesh.creation.box((0.1, 0.06, 0.04)), 2.4) is None
    assert "3.00 kg" in (_verdict(trimesh.creation.box((0.1, 0.06, 0.04)), 3.0) or "")


def test_what_topples_at_a_breath_is_refused():
    box = trimesh.creation.box((0.1, 0.06, 0.04)).apply_translation((0, 0, 0.02))
    vertices, faces = np.array(box.vertices), np.array(box.faces)
    assert unfit(vertices, faces, Rest(np.eye(3), 0.0, 1.2), 0.1) is None
    why = unfit(vertices, faces, Rest(np.eye(3), 0.0, 0.7), 0.1)
    assert why is not None and "no stable face" in why and "0.7 degrees" in why


def test_what_is_flat_is_refused():
    sheet = np.array([[0, 0, 0], [0.1, 0, 0], [0.1, 0.1, 0], [0, 0.1, 0]], float)
    faces = np.array([[0, 1, 2], [0, 2, 3]])
    assert "flat" in (unfit(sheet, faces, rest_of(sheet), 0.1) or "")


def test_a_plank_lying_flat_is_held_across_but_not_through_the_table():
    plank = trimesh.creation.box((0.2, 0.2, 0.02)).apply_translation((0, 0, 0.01))
    faces = np.array(plank.faces)
    assert not holdable(np.array(plank.vertices), faces)
    raised = np.array(plank.vertices) + [0, 0, 0.05]
    assert holdable(raised, faces)
