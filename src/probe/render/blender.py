"""Draws with Blender's EEVEE. Runs in a process of its own; knows no physics.

A picture's bytes depend on (objects, camera, light, grainless or not) alone: every one is drawn in
a file emptied and filled anew, with a fixed number of samples. (Those of a series are drawn in one
file, in which things are moved.)
"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Iterable, Iterator, Sequence
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

import bpy
import numpy as np
from PIL import Image

from probe.assets.mesh.mesh import TexturedMesh
from probe.render.blender_parts import FAR, camera_of, mesh_of, sun_of, world_of
from probe.render.illumination import Illumination
from probe.render.packing import table_quad
from probe.render.protocol import DrawRequest, DrawSeries, Load
from probe.scene.scene import PlacedObject
from probe.types import Array, Camera, Pose

SAMPLES = 8
"""Of each pixel. On two cores without GPU each costs about three seconds."""

GRAINLESS_SAMPLES = 20
"""Of each pixel of a picture whose shadows may show no grain."""

GRAINLESS_RAYS = 4
"""From each of those samples to each light, instead of one. EEVEE allows no more."""

FILM_SAMPLES = 4
"""Of each pixel of a series."""

Things = dict[tuple[int, str], Any]
"""Blender's objects by instance and id."""


def paint(load: Load, request: DrawRequest) -> Array:
    """Colour picture, uint8, shape (h, w, 3)."""
    assert request.light is not None
    scene, _ = _filled(load, request.objects, request.light)
    _set_up(scene, request.camera, FAR, GRAINLESS_SAMPLES if request.grainless else SAMPLES)
    if request.grainless:
        scene.eevee.shadow_ray_count = GRAINLESS_RAYS
    return _rendered(scene)


def paint_series(load: Load, request: DrawSeries) -> Iterator[Array]:
    """Colour pictures, uint8, each of shape (h, w, 3)."""
    scene, things = _filled(load, request.objects, request.light)
    _set_up(scene, request.camera, request.far, FILM_SAMPLES)
    for moment in request.moments:
        _place(things, moment)
        yield _rendered(scene)


def _filled(load: Load, objects: Sequence[PlacedObject], light: Illumination) -> tuple[Any, Things]:
    """A scene emptied, and filled with the table, light, and each of these objects once."""
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene: Any = bpy.context.scene
    glossy = light.sun is not None
    each = {(item.instance, item.object_id): item for item in objects}.values()
    _show(scene, "table", table_quad(load.table), [PlacedObject(0, "table", Pose())], glossy)
    things: Things = {}
    for name in sorted({item.object_id for item in each}):
        placed = [item for item in each if item.object_id == name]
        things |= _show(scene, name, load.meshes[name], placed, glossy)
    scene.world = world_of(light)
    if light.sun:
        scene.collection.objects.link(sun_of(light.sun))
    return scene, things


def _show(
    scene: Any, name: str, mesh: TexturedMesh, placed: list[PlacedObject], glossy: bool
) -> Things:
    made = mesh_of(name, mesh, glossy=glossy)
    things: Things = {}
    for item in placed:
        thing = bpy.data.objects.new(f"{name}/{item.instance}", made)
        thing.matrix_world = item.pose.matrix.T.tolist()
        scene.collection.objects.link(thing)
        things[item.instance, name] = thing
    return things


def _place(things: Things, objects: Iterable[PlacedObject]) -> None:
    """Show exactly these objects at their poses."""
    wanted = {(item.instance, item.object_id): item.pose for item in objects}
    for key, thing in things.items():
        thing.hide_render = key not in wanted
        if key in wanted:
            thing.matrix_world = wanted[key].matrix.T.tolist()


def _set_up(scene: Any, camera: Camera, far: float, samples: int) -> None:
    scene.camera = camera_of(camera, far)
    render, eevee = scene.render, scene.eevee
    render.engine = "BLENDER_EEVEE"
    render.resolution_x, render.resolution_y = camera.width_px, camera.height_px
    render.resolution_percentage = 100
    render.dither_intensity = 0.0
    render.image_settings.file_format = "PNG"
    render.image_settings.color_mode = "RGB"
    render.image_settings.compression = 0
    # "AgX", the default, changes colours.
    scene.view_settings.view_transform = "Standard"
    scene.view_settings.look = "None"
    eevee.taa_render_samples = samples
    # Light from all around reaches what nothing stands over: else everything looks flat.
    eevee.use_raytracing = True
    eevee.use_fast_gi = True
    eevee.fast_gi_method = "AMBIENT_OCCLUSION_ONLY"


def _rendered(scene: Any) -> Array:
    with tempfile.TemporaryDirectory(prefix="probe-blender-") as folder:
        file = Path(folder) / "picture.png"
        scene.render.filepath = str(file)
        bpy.ops.render.render(write_still=True)
        with Image.open(file) as picture:
            return np.asarray(picture.convert("RGB"))


def serve(client: Connection) -> None:
    """Keep what is loaded and send what is to be drawn, until the client goes away."""
    load: Load | None = None
    while True:
        try:
            request: Load | DrawRequest | DrawSeries = client.recv()
        except EOFError:
            return
        if isinstance(request, Load):
            load = request
            continue
        assert load is not None
        if isinstance(request, DrawRequest):
            client.send(paint(load, request))
            continue
        for picture in paint_series(load, request):
            client.send(picture)


if __name__ == "__main__":
    serve(Connection(int(sys.argv[1])))
