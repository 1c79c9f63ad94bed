"""Draws with Filament through `mujoco.mjrf`. Runs in a forked child only; knows no physics.

A picture's bytes must depend on (objects, camera, light) alone, and Filament's dithering depends
on how many frames a Context has drawn: so every RGB picture is the first frame of a fresh Context.
(A film's pictures are drawn in series, each in a fresh one.)
Depth and labels don't dither; they are drawn again and again with one Context.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

import mujoco
import mujoco.studio.window  # pyright: ignore[reportUnusedImport] # registers material files
import numpy as np
from mujoco import mjrf

from probe.render.filament_parts import FAR, NEAR, Factory, Uploaded, filament_camera
from probe.render.gaps import without_gaps
from probe.render.light_packing import PackedLight
from probe.render.packing import PackedMesh
from probe.render.sight import may_show
from probe.scene.scene import PlacedObject
from probe.types import Array, Camera

# The colour grading's defaults double the brightness; linear tone mapping keeps textures' colours.
_LOOK = """
<mujoco><custom>
  <numeric name="filament.cg.shadows" data="1 1 1 0"/>
  <numeric name="filament.cg.midtones" data="1 1 1 0"/>
  <numeric name="filament.cg.highlights" data="1 1 1 0"/>
  <text name="filament.cg.tone_mapping" data="linear"/>
  {}
</custom></mujoco>
"""

# Ambient occlusion blurred over depth steps of more than 6 mm draws a bright halo round things.
_FINE = """<numeric name="filament.ao.bilateral_threshold" data="0.006"/>
  <text name="filament.shadows.type" data="pcss"/>"""

# "pcss" lets light of lamps that aren't far away through thin things.
_NEAR = _FINE.replace("pcss", "pcf")

# Less than half of the time: 0.44 instead of 1.0 CPU s for 864 x 616 pixels with robot and room.
_QUICK = """<numeric name="filament.ao.enabled" data="0"/>
  <text name="filament.shadows.type" data="pcf"/>"""


_BACKGROUND = [0.55, 0.55, 0.55]
"""Linear grey behind the table where there is no backdrop."""


class Drawer:
    """One Filament Context holding the table and any of the loaded objects, lit in one way.

    Args:
        meshes: The objects, by id.
        table: The table's top.
        light: What falls on them.
        quick: Whether shadows have hard edges, and corners aren't darkened: for films.
    """

    def __init__(
        self,
        meshes: dict[str, PackedMesh],
        table: PackedMesh,
        light: PackedLight,
        *,
        quick: bool = False,
    ) -> None:
        self._meshes = meshes
        api = mjrf.GraphicsApi.GRAPHICS_API_VULKAN
        self._context = mjrf.Context(mjrf.ContextConfig(graphics_api=api))
        self._scene = self._context.create_scene(mjrf.SceneParams())
        near = light.sun is not None and light.sun.distance is not None
        look = _LOOK.format(_QUICK if quick else _NEAR if near else _FINE)
        self._scene.configure_from_model(mujoco.MjModel.from_xml_string(look))
        self._factory = Factory(self._context, glossy=light.sun is not None, quick=quick)
        self._uploaded: dict[str, Uploaded] = {}
        self._renderables: dict[tuple[int, str], mjrf.Renderable] = {}
        self._shown: set[tuple[int, str]] = set()
        self._backdrop = light.backdrop is not None
        self._casts_shadows = light.sun is not None
        self._add_light(light)
        self._table = self._factory.renderable(self._factory.upload(table), label=0)
        self._scene.add_renderable(self._table)

    def rgb(self, objects: Sequence[PlacedObject], camera: Camera, far: float = FAR) -> Array:
        """Colour picture, uint8, shape (h, w, 3), of what lies within so many metres."""
        self._place(objects if self._casts_shadows else self._in_sight(objects, camera))
        picture = _canvas(camera, (3,), np.uint8)
        self._read(camera, picture, mjrf.DrawMode.DRAW_MODE_DEFAULT, far)
        return picture

    def _in_sight(self, objects: Sequence[PlacedObject], camera: Camera) -> list[PlacedObject]:
        """Those that may show. To hand over a texture takes as long as to draw the object."""
        return [
            it for it in objects if may_show(self._meshes[it.object_id].bounds, it.pose, camera)
        ]

    def labels(self, objects: Iterable[PlacedObject], camera: Camera) -> Array:
        """Instance numbers, int32, shape (h, w); 0 where no object is."""
        self._place(objects)
        code = _canvas(camera, (3,), np.uint8)
        self._read(camera, code, mjrf.DrawMode.DRAW_MODE_SEGMENTATION_BY_ID)
        low, middle, high = (code[..., channel].astype(np.int32) for channel in range(3))
        return low + (middle << 8) + (high << 16)

    def depth(self, objects: Iterable[PlacedObject], camera: Camera) -> Array:
        """Planar depth in metres, float32, shape (h, w).

        Filament's depth is reversed: z = n f / (n + d (f - n)) for clipping distances n and f.
        """
        self._place(objects)
        reversed_z = _canvas(camera, (), np.float32)
        self._read(camera, reversed_z, mjrf.DrawMode.DRAW_MODE_DEPTH)
        return without_gaps(
            np.float32(NEAR * FAR) / (np.float32(NEAR) + reversed_z * np.float32(FAR - NEAR))
        )

    def silhouette(self, item: PlacedObject, camera: Camera) -> Array:
        """Mask of one object standing alone, bool, shape (h, w)."""
        return self.labels([item], camera) == item.instance

    def _add_light(self, light: PackedLight) -> None:
        self._scene.add_light(self._factory.image_light(light.around))
        for lamp in self._factory.sun(light.sun) if light.sun else ():
            self._scene.add_light(lamp)
        if light.backdrop is not None:
            self._scene.set_skybox(self._factory.backdrop(light.backdrop))

    def _place(self, objects: Iterable[PlacedObject]) -> None:
        """Show exactly these objects at their poses."""
        wanted: set[tuple[int, str]] = set()
        for item in objects:
            key = (item.instance, item.object_id)
            wanted.add(key)
            if key not in self._renderables:
                mesh = self._meshes[item.object_id]
                parts = self._uploaded.get(item.object_id) or self._factory.upload(mesh)
                self._uploaded[item.object_id] = parts
                self._renderables[key] = self._factory.renderable(parts, label=item.instance)
            position = np.array(item.pose.position, np.float32)
            rotation = item.pose.rotation.astype(np.float32).reshape(9)
            self._renderables[key].set_pose(position, rotation)
        for key in sorted(wanted - self._shown):
            self._scene.add_renderable(self._renderables[key])
        for key in sorted(self._shown - wanted):
            self._scene.remove_renderable(self._renderables[key])
        self._shown = wanted

    def _read(self, camera: Camera, canvas: Array, mode: mjrf.DrawMode, far: float = FAR) -> None:
        """Draw one frame into a C-contiguous array."""
        shown = mode == mjrf.DrawMode.DRAW_MODE_DEFAULT
        self._context.set_clear_color(_BACKGROUND if shown else [0.0, 0.0, 0.0])
        layout = (
            mjrf.PixelFormat.PIXEL_FORMAT_R32F
            if canvas.dtype == np.float32
            else mjrf.PixelFormat.PIXEL_FORMAT_RGB8
        )
        target = self._context.create_render_target(
            mjrf.RenderTargetConfig(
                width=camera.width_px, height=camera.height_px, color_format=layout
            )
        )
        target.resize(camera.width_px, camera.height_px)
        request = mjrf.RenderRequest(
            scene=self._scene,
            camera=filament_camera(camera, far),
            target=target,
            draw_mode=mode,
            reflections=False,
            haze=False,
            skybox=shown and self._backdrop,
        )
        request.viewport.width = camera.width_px
        request.viewport.height = camera.height_px
        reading = mjrf.ReadRequest(target=target)
        reading.set_buffer(canvas)
        self._context.wait_for_frame(self._context.render([request], [reading]))


def _canvas(camera: Camera, channels: tuple[int, ...], dtype: type[np.generic]) -> Array:
    return np.zeros((camera.height_px, camera.width_px, *channels), dtype)
