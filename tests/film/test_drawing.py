"""What stands on a film's stage is drawn as the scene says: in its looks, by the chosen engine."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from probe.assets.looks import Looks
from probe.film import drawing
from probe.film.drawing import stage_drawer
from probe.film.watched_world import TableMoment
from probe.scene.setup import newest
from probe.stage.cameras import whole_view
from probe.tasks.suite_file import demo_suite

SCENE = demo_suite().tasks[0].scene


class Listener:
    """Stands for a renderer, and keeps what it is given."""

    def __init__(self, cache, engine) -> None:
        self.name = engine
        self.series_lengths: list[int] = []

    def __enter__(self):
        return self

    def __exit__(self, *_) -> None: ...

    def load(self, meshes, table) -> None:
        self.meshes, self.top = meshes, table

    def series(self, moments, camera, light, far):
        self.series_lengths.append(len(moments))
        return tuple(range(len(moments)))


@pytest.mark.parametrize("looks", [1, 2])
def test_things_and_table_have_the_scenes_looks(library, monkeypatch, looks: Looks) -> None:
    scene = replace(SCENE, setup=newest(SCENE.setup, looks=looks))
    monkeypatch.setattr(drawing, "Renderer", Listener)
    with stage_drawer(scene, library, "filament") as drawer:
        heard = drawer.renderer
    assert isinstance(heard, Listener)
    for placed in scene.objects[:3]:
        drawn = heard.meshes[placed.object_id].surface.texture
        own, other = (
            library.body(placed.object_id, each).mesh.surface.texture for each in (looks, 3 - looks)
        )
        assert np.array_equal(drawn, own) and not np.array_equal(drawn, other)
    assert np.array_equal(heard.top.surface.texture, library.table(scene.table, looks).texture)


@pytest.mark.parametrize("engine", ["filament", "blender"])
def test_a_long_film_is_drawn_in_series_by_the_chosen_engine(library, monkeypatch, engine) -> None:
    monkeypatch.setattr(drawing, "Renderer", Listener)
    moment = TableMoment(0.0, np.array(SCENE.setup.mount.parked), 0.1, SCENE.objects)
    with stage_drawer(SCENE, library, engine) as drawer:
        assert drawer.renderer.name == engine
        numbers = [number for number, _ in drawer.draw_all([moment] * 100, VIEW)]
    assert numbers == list(range(100))
    assert isinstance(drawer.renderer, Listener)
    lengths = drawer.renderer.series_lengths
    assert sum(lengths) == 100 and set(lengths[:-1]) == {drawing.SERIES[engine]}


VIEW = whole_view(SCENE.setup, 64, 48)
