"""Looks at scenes the way the rules measure them: labels, visibilities, silhouettes. No physics."""

from __future__ import annotations

from collections.abc import Collection, Iterable

import numpy as np

from probe.assets.library import Library
from probe.assets.mesh import Surface, TexturedMesh
from probe.render.protocol import TableTop
from probe.render.renderer import Renderer
from probe.scene.layout import TABLE_SIZE, top_camera
from probe.scene.scene import Scene
from probe.scene.visibility import Visibility, visibilities
from probe.tasks.truth import Silhouette
from probe.types import Array

_GREY = Surface(np.full((1, 1, 3), 128, dtype=np.uint8))


class View:
    """The fixed camera's view of scenes that hold certain objects; replaces what was loaded."""

    def __init__(self, renderer: Renderer, library: Library, object_ids: Iterable[str]) -> None:
        self._renderer = renderer
        self._meshes = {id: library.body(id).mesh for id in dict.fromkeys(object_ids)}
        shapes = {id: _untextured(mesh) for id, mesh in self._meshes.items()}
        renderer.load(shapes, TableTop(_GREY, 1.0, TABLE_SIZE))

    def labels(self, scene: Scene) -> Array:
        """Instance numbers, shape (h, w)."""
        labels = self._renderer.draw(scene.objects, top_camera(), rgb=False).labels
        assert labels is not None
        return labels

    def visibility(self, scene: Scene, labels: Array, of: Collection[int]) -> dict[int, Visibility]:
        """Visibility of some instances of a scene with these labels."""
        placed = [item for item in scene.objects if item.instance in of]
        return visibilities(labels, self._renderer.outlines(placed, top_camera()))

    def silhouettes(self, scene: Scene, of: Collection[int]) -> dict[int, Silhouette]:
        """Silhouettes of some instances of a scene."""
        placed = [item for item in scene.objects if item.instance in of]
        masks = self._renderer.outlines(placed, top_camera())
        return {
            item.instance: Silhouette(
                masks[item.instance],
                float(item.pose.apply(self._meshes[item.object_id].vertices)[:, 2].max()),
            )
            for item in placed
        }


def _untextured(mesh: TexturedMesh) -> TexturedMesh:
    """Labels need no texture, and a scene's textures take a second to hand over."""
    return TexturedMesh(mesh.vertices, mesh.normals, mesh.uvs, mesh.faces, _GREY)
