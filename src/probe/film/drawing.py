"""Draws moments of footage: objects, robot and room, in series of a fixed length."""

from __future__ import annotations

from collections.abc import Generator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass

from probe.assets.library import Library
from probe.film.watched_world import TableMoment
from probe.render.photograph import load_scene
from probe.render.renderer import Renderer
from probe.scene.scene import Scene
from probe.scene.setup import RendererName
from probe.stage.cameras import FAR
from probe.stage.light import stage_light
from probe.stage.stage import FilmStage
from probe.types import Array, Camera

SERIES: dict[RendererName, int] = {"filament": 48, "blender": 8}
"""Pictures drawn one after another. A film's bytes depend on it. The first of each takes Filament 2
CPU seconds more, and each later one leaves 5 MB of memory behind; with Blender nobody hears of any
before all of them are there."""


@dataclass(frozen=True, eq=False)
class StageDrawer:
    """A renderer of its own with a scene's objects and stage loaded; see stage_drawer()."""

    renderer: Renderer
    stage: FilmStage

    def draw(self, moments: Sequence[TableMoment], camera: Camera) -> tuple[Array, ...]:
        """Pictures of moments, as many as a series may have, uint8, each of shape (h, w, 3)."""
        placed = [
            (*moment.objects, *self.stage.placed(moment.joints, moment.opening))
            for moment in moments
        ]
        return self.renderer.series(placed, camera, stage_light(), FAR)

    def draw_all(
        self, moments: Sequence[TableMoment], camera: Camera
    ) -> Generator[tuple[int, Array]]:
        """Numbers and pictures of any number of moments, in order."""
        most = SERIES[self.renderer.name]
        for start in range(0, len(moments), most):
            drawn = self.draw(moments[start : start + most], camera)
            yield from enumerate(drawn, start)


@contextmanager
def stage_drawer(scene: Scene, library: Library, engine: RendererName) -> Generator[StageDrawer]:
    """Start a renderer for a scene's objects and its stage, and end it.

    No station and no tool ever sees with it: they have renderers of their own, which are given
    objects alone.

    Args:
        scene: Whose table it is.
        library: Has its objects.
        engine: What draws.

    Raises:
        NoGraphicsDriver, MissingExtra: As Renderer.
    """
    table = library.table(scene.table, scene.setup.looks)
    stage = FilmStage.of(scene.setup, table.texture)
    with Renderer(library.light_cache, engine) as renderer:
        load_scene(renderer, scene, library, table, stage.meshes)
        yield StageDrawer(renderer, stage)
