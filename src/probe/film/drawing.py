"""Draws moments of footage: objects, robot and room, in series of a fixed length."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass

from probe.assets.library import Library
from probe.film.footage import Footage
from probe.film.watched_world import TableMoment
from probe.render.protocol import TableTop
from probe.render.renderer import Renderer
from probe.stage.cameras import FAR
from probe.stage.light import stage_light
from probe.stage.stage import FilmStage
from probe.types import Array, Camera

SERIES = 48
"""Pictures drawn one after another. A film's bytes depend on it. The first of each takes 2 CPU
seconds more, and each later one leaves 5 MB of memory behind."""


@dataclass(frozen=True, eq=False)
class StageDrawer:
    """A renderer of its own with a footage's objects and stage loaded; see stage_drawer()."""

    renderer: Renderer
    stage: FilmStage

    def draw(self, moments: Sequence[TableMoment], camera: Camera) -> tuple[Array, ...]:
        """Pictures of moments, at most SERIES of them, uint8, each of shape (h, w, 3)."""
        placed = [
            (*moment.objects, *self.stage.placed(moment.joints, moment.opening))
            for moment in moments
        ]
        return self.renderer.series(placed, camera, stage_light(), FAR)

    def draw_all(
        self, moments: Sequence[TableMoment], camera: Camera
    ) -> Generator[tuple[int, Array]]:
        """Numbers and pictures of any number of moments, in order."""
        for start in range(0, len(moments), SERIES):
            drawn = self.draw(moments[start : start + SERIES], camera)
            yield from enumerate(drawn, start)


@contextmanager
def stage_drawer(footage: Footage, library: Library) -> Generator[StageDrawer]:
    """Start a renderer for a footage's stage, and end it.

    No station and no tool ever sees with it: they have renderers of their own, which are given
    objects alone.
    """
    scene = footage.task.scene
    table = library.table(scene.table)
    stage = FilmStage.of(scene.setup, table.texture)
    meshes = {each.object_id: library.body(each.object_id).mesh for each in scene.objects}
    top = TableTop(table.surface, table.tile_size, scene.setup.table_size)
    with Renderer(library.light_cache) as renderer:
        renderer.load({**meshes, **stage.meshes}, top)
        yield StageDrawer(renderer, stage)
