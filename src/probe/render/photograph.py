"""From a Scene to frames: hands a renderer what the scene needs and asks for pictures."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

from probe.assets.library import Library
from probe.assets.mesh.mesh import TexturedMesh
from probe.assets.tables import TableMaterial
from probe.render.illumination import AMBIENT, Illumination
from probe.render.protocol import TableTop
from probe.render.renderer import Renderer
from probe.scene.scene import Scene
from probe.scene.visibility import Visibility, visibilities
from probe.types import Array, Camera, Frame


def load_scene(
    renderer: Renderer,
    scene: Scene,
    library: Library,
    table: TableMaterial | None = None,
    more: Mapping[str, TexturedMesh] = MappingProxyType({}),
) -> None:
    """Give the renderer every object of the scene, and its table.

    Args:
        renderer: What it had loaded is replaced.
        scene: Its set-up says how things look.
        library: Has its objects.
        table: Another one than the scene's own.
        more: Meshes beside the scene's, by id.
    """
    looks = scene.setup.looks
    meshes = {item.object_id: library.body(item.object_id, looks).mesh for item in scene.objects}
    top = table or library.table(scene.table, looks)
    renderer.load({**meshes, **more}, TableTop(top.surface, top.tile_size, scene.setup.table_size))


def photograph(
    renderer: Renderer,
    scene: Scene,
    *,
    rgb: bool = True,
    camera: Camera | None = None,
    light: Illumination = AMBIENT,
    grainless: bool = False,
) -> Frame:
    """A frame of a loaded scene; from the fixed top-down camera unless another is given."""
    seen_from = camera or scene.setup.camera()
    return renderer.draw(scene.objects, seen_from, rgb=rgb, light=light, grainless=grainless)


def labels_of(renderer: Renderer, scene: Scene, camera: Camera | None = None) -> Array:
    """Instance numbers of a loaded scene's picture, shape (h, w), as photograph sees it."""
    return renderer.labels(scene.objects, camera or scene.setup.camera())


def measure(
    renderer: Renderer, scene: Scene, camera: Camera | None = None
) -> dict[int, Visibility]:
    """Visibility of each object of a loaded scene, by ghost removal, as photograph sees it."""
    labels = labels_of(renderer, scene, camera)
    return visibilities(labels, renderer.outlines(scene.objects, camera or scene.setup.camera()))
