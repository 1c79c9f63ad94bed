"""Looks at scenes the way the rules measure them: labels, visibilities, silhouettes. No physics."""

from __future__ import annotations

from collections.abc import Collection, Iterable
from copy import copy

import numpy as np

from probe.assets.library import Library
from probe.assets.mesh.lattice import places, spots, topmost
from probe.assets.mesh.mesh import Material
from probe.render.protocol import TableTop
from probe.render.renderer import Renderer
from probe.scene.cameras import View
from probe.scene.scene import PlacedObject, Scene
from probe.scene.setup import Setup
from probe.scene.visibility import Visibility, visibilities
from probe.tasks.truth import Silhouette
from probe.types import Array, Camera

_SPOTS = 20_000
_COARSE = 8
_SKIN = 0.006
_GREY = Material(np.full((1, 1, 3), 128, dtype=np.uint8))


class SceneView:
    """A fixed camera's view of scenes that hold certain objects; replaces what was loaded."""

    def __init__(
        self,
        renderer: Renderer,
        library: Library,
        object_ids: Iterable[str],
        setup: Setup,
        view: View = "top",
    ) -> None:
        self.view: View = view
        self.camera = setup.camera(view)
        self._setup = setup
        self._renderer = renderer
        self._meshes = {id: library.form(id).mesh for id in dict.fromkeys(object_ids)}
        renderer.load(self._meshes, TableTop(_GREY, 1.0, setup.table_size))

    def seen_from(self, view: View) -> SceneView:
        """The same objects as another of the cameras sees them."""
        other = copy(self)
        other.view, other.camera = view, self._setup.camera(view)
        return other

    def labels(self, scene: Scene) -> Array:
        """Instance numbers, shape (h, w)."""
        return self._renderer.labels(scene.objects, self.camera)

    def visibility(self, scene: Scene, labels: Array, of: Collection[int]) -> dict[int, Visibility]:
        """Visibility of some instances of a scene with these labels."""
        placed = [item for item in scene.objects if item.instance in of]
        return visibilities(labels, self._renderer.outlines(placed, self.camera))

    def shown(self, scene: Scene, labels: Array, number: int) -> tuple[Array, Array]:
        """Spots of an object that show: faces, shape (n,), and weights, shape (n, 3)."""
        mesh = self._meshes[scene[number].object_id]
        face, weights = spots(mesh.vertices, mesh.faces, _SPOTS)
        points = places(mesh.vertices, mesh.faces, face, weights)
        shown = _spots_shown(scene, labels, number, points, self.camera)
        return face[shown], weights[shown]

    def top_shown(self, scene: Scene, labels: Array, number: int) -> float:
        """Height above the table of the highest spot of an object that shows, metres; else 0."""
        mesh = self._meshes[scene[number].object_id]
        face, weights = self.shown(scene, labels, number)
        points = scene[number].pose.apply(places(mesh.vertices, mesh.faces, face, weights))
        return float(points[:, 2].max(initial=0.0))

    def top_of(self, placed: PlacedObject) -> float:
        """Height above the table of an object's highest point, metres."""
        return self.reach_of(placed)[1]

    def reach_of(self, placed: PlacedObject) -> tuple[float, float]:
        """Heights above the table of an object's lowest and highest point, metres."""
        heights = placed.pose.apply(self._meshes[placed.object_id].vertices)[:, 2]
        return float(heights.min()), float(heights.max())

    def silhouettes(self, scene: Scene, of: Collection[int]) -> dict[int, Silhouette]:
        """Silhouettes of some instances of a scene."""
        placed = [item for item in scene.objects if item.instance in of]
        masks = self._renderer.outlines(placed, self.camera)
        return {
            item.instance: Silhouette(
                masks[item.instance],
                self.top_of(item),
            )
            for item in placed
        }


def _spots_shown(scene: Scene, labels: Array, number: int, points: Array, camera: Camera) -> Array:
    """Which points on an object, in its frame, shape (n, 3), show; a face turned away doesn't.

    Points that fall on the same pixel are told apart by height: the highest one shows.
    """
    world = scene[number].pose.apply(points)
    pixels = np.floor(camera.project(world)).astype(int)
    height, width = labels.shape
    u, v = pixels[:, 0].clip(0, width - 1), pixels[:, 1].clip(0, height - 1)
    cell = (v // _COARSE) * width + u // _COARSE
    return (labels[v, u] == number) & topmost(cell, world[:, 2], height * width, _SKIN)
