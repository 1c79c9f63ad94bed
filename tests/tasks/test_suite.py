from __future__ import annotations

from dataclasses import replace

import pytest

from probe.assets.library import open_library
from probe.assets.mesh import Body, ConvexPiece
from probe.errors import BadData
from probe.scene.scene import PlacedObject, Scene
from probe.tasks.suite import body_digest, check_objects, freeze
from probe.types import Pose
from shapes import box
from task_examples import FIND

SCENE = Scene(1, "oak_planks", (PlacedObject(2, "proc_lime", Pose()),))


def test_the_digest_changes_with_mesh_and_pieces():
    mesh = box(0.1, 0.1, 0.1, 200, 0, 0)
    piece = ConvexPiece(mesh.vertices.astype(float))
    wider = ConvexPiece(piece.vertices * 1.001)
    bodies = [
        Body(mesh, (piece,)),
        Body(mesh, (wider,)),
        Body(mesh, (piece, piece)),
        Body(box(0.1, 0.1, 0.1, 201, 0, 0), (piece,)),
    ]
    assert len({body_digest(body) for body in bodies}) == 4
    assert body_digest(bodies[0]) == body_digest(Body(mesh, (piece,)))


def test_a_library_that_differs_is_refused(cache):
    library = open_library("procedural", None, cache)
    suite = freeze("small", (replace(FIND, scene=SCENE, targets=(2,)),), library)
    assert set(suite.objects) == {"proc_lime"}
    check_objects(suite, library)
    with pytest.raises(BadData, match="proc_lime has changed since"):
        check_objects(replace(suite, objects={"proc_lime": "0" * 16}), library)
    with pytest.raises(BadData, match="there is no proc_unicorn here"):
        check_objects(replace(suite, objects={"proc_unicorn": "0" * 16}), library)
