"""Things in a recording look as the scene says."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from probe.assets.looks import Looks
from probe.film.recording.bodies import object_entity, tell_looks
from probe.scene.setup import newest
from probe.tasks.suite_file import demo_suite

SCENE = demo_suite().tasks[0].scene


class Listener:
    """Stands for a recording, and keeps its meshes."""

    def __init__(self) -> None:
        self.meshes = {}

    def body(self, entity, mesh, colours=None) -> None:
        self.meshes[entity] = mesh


@pytest.mark.parametrize("looks", [1, 2])
def test_things_have_the_scenes_looks(library, looks: Looks) -> None:
    writer: Any = Listener()
    tell_looks(writer, replace(SCENE, setup=newest(SCENE.setup, looks=looks)), library)
    for placed in SCENE.objects[:3]:
        mesh = writer.meshes[object_entity(placed.instance, library, placed.object_id)]
        own, other = (
            library.body(placed.object_id, each).mesh.surface.texture for each in (looks, 3 - looks)
        )
        assert np.array_equal(mesh.surface.texture, own)
        assert not np.array_equal(mesh.surface.texture, other)
