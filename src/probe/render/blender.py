"""Draws with Blender's EEVEE. Runs in a process of its own; knows no physics.

A picture's bytes depend on (objects, camera, light) alone: every one is drawn in a file emptied
and filled anew, with a fixed number of samples.
"""

from __future__ import annotations

import sys
import tempfile
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any

import bpy
import numpy as np
from PIL import Image

from probe.assets.mesh.mesh import TexturedMesh
from probe.render.blender_parts import camera_of, mesh_of, sun_of, world_of
from probe.render.packing import table_quad
from probe.render.protocol import DrawRequest, Load
from probe.scene.scene import PlacedObject
from probe.types import Array, Camera, Pose

SAMPLES = 8
"""Of each pixel. On two cores without GPU each costs about three seconds."""


def paint(load: Load, request: DrawRequest) -> Array:
    """Colour picture, uint8, shape (h, w, 3)."""
    light = request.light
    assert light is not None
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene: Any = bpy.context.scene
    glossy = light.sun is not None
    _show(scene, "table", table_quad(load.table), [PlacedObject(0, "table", Pose())], glossy)
    for name in sorted({item.object_id for item in request.objects}):
        placed = [item for item in request.objects if item.object_id == name]
        _show(scene, name, load.meshes[name], placed, glossy)
    scene.world = world_of(light)
    if light.sun:
        scene.collection.objects.link(sun_of(light.sun))
    scene.camera = camera_of(request.camera)
    _set_up(scene, request.camera)
    return _rendered(scene)


def _show(
    scene: Any, name: str, mesh: TexturedMesh, placed: list[PlacedObject], glossy: bool
) -> None:
    made = mesh_of(name, mesh, glossy=glossy)
    for item in placed:
        thing = bpy.data.objects.new(f"{name}/{item.instance}", made)
        thing.matrix_world = item.pose.matrix.T.tolist()
        scene.collection.objects.link(thing)


def _set_up(scene: Any, camera: Camera) -> None:
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
    eevee.taa_render_samples = SAMPLES
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
    """Keep what is loaded and answer each Draw with a picture, until the client goes away."""
    load: Load | None = None
    while True:
        try:
            request: Load | DrawRequest = client.recv()
        except EOFError:
            return
        if isinstance(request, Load):
            load = request
        else:
            assert load is not None
            client.send(paint(load, request))


if __name__ == "__main__":
    serve(Connection(int(sys.argv[1])))
