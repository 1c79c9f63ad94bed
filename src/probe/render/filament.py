"""Draws with Filament through `mujoco.mjrf`. Runs in a forked child only; knows no physics.

A picture's bytes must depend on (objects, camera) alone, and Filament's dithering depends on how
many frames a Context has drawn: so every RGB picture is the first frame of a fresh Context.
Depth and labels don't dither; they are drawn again and again with one Context.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

import mujoco
import mujoco.studio.window  # pyright: ignore[reportUnusedImport] # registers material files
import numpy as np
from mujoco import mjrf

from probe.assets.mesh import Surface, TexturedMesh
from probe.render.lighting import AMBIENT_RADIANCE, UNIT_INTENSITY, uniform_environment
from probe.render.protocol import TableTop
from probe.scene.scene import PlacedObject
from probe.types import Array, Camera

NEAR, FAR = 0.2, 4.0
"""Clipping distances in metres."""

# The colour grading's defaults double the brightness; linear tone mapping keeps textures' colours.
# Ambient occlusion blurred over depth steps of more than 6 mm draws a bright halo round things.
_LOOK = """
<mujoco><custom>
  <numeric name="filament.cg.shadows" data="1 1 1 0"/>
  <numeric name="filament.cg.midtones" data="1 1 1 0"/>
  <numeric name="filament.cg.highlights" data="1 1 1 0"/>
  <text name="filament.cg.tone_mapping" data="linear"/>
  <numeric name="filament.ao.bilateral_threshold" data="0.006"/>
</custom></mujoco>
"""


@dataclass(frozen=True, eq=False)
class PackedMesh:
    """A mesh as Filament's buffers take it."""

    vertices: bytes
    indices: bytes
    vertex_count: int
    index_count: int
    bounds: tuple[Array, Array]
    surface: Surface


def pack(mesh: TexturedMesh) -> PackedMesh:
    """Interleave position, tangent frame and texture coordinates."""
    columns = [mesh.vertices, _tangent_frames(mesh.normals), mesh.uvs]
    return PackedMesh(
        vertices=np.concatenate(columns, axis=1).astype(np.float32).tobytes(),
        indices=mesh.faces.astype(np.uint32).tobytes(),
        vertex_count=len(mesh.vertices),
        index_count=mesh.faces.size,
        bounds=(mesh.vertices.min(0).astype(np.float32), mesh.vertices.max(0).astype(np.float32)),
        surface=mesh.surface,
    )


def pack_table(table: TableTop) -> PackedMesh:
    """The table's top as one quad at z = 0, its texture repeated."""
    corners = np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], dtype=np.float32)
    vertices = corners * np.array([*table.extent, 0.0], dtype=np.float32) / 2
    uvs = vertices[:, :2] * np.array([1, -1], np.float32) / np.float32(table.tile_size)
    normals = np.tile(np.array([0, 0, 1], np.float32), (4, 1))
    faces = np.array([[0, 1, 2], [0, 2, 3]], dtype=np.int32)
    return pack(TexturedMesh(vertices, normals, uvs, faces, table.surface))


def _tangent_frames(normals: Array) -> Array:
    """Quaternions xyzw, shape (n, 4), that turn +z into each normal by the shortest way."""
    w = 1 + normals[:, 2]
    frames = np.stack([-normals[:, 1], normals[:, 0], np.zeros(len(normals)), w], axis=1)
    frames[w < 1e-6] = (1, 0, 0, 0)
    return frames / np.linalg.norm(frames, axis=1, keepdims=True)


class Drawer:
    """One Filament Context holding the table and any of the loaded objects."""

    def __init__(self, meshes: dict[str, PackedMesh], table: PackedMesh) -> None:
        self._meshes = meshes
        api = mjrf.GraphicsApi.GRAPHICS_API_VULKAN
        self._context = mjrf.Context(mjrf.ContextConfig(graphics_api=api))
        self._context.set_clear_color([0.0, 0.0, 0.0])
        self._scene = self._context.create_scene(mjrf.SceneParams())
        self._scene.configure_from_model(mujoco.MjModel.from_xml_string(_LOOK))
        # Filament reads these later, from another thread, and doesn't own them.
        self._alive: list[object] = []
        self._uploaded: dict[str, tuple[mjrf.Mesh, mjrf.Texture]] = {}
        self._renderables: dict[tuple[int, str], mjrf.Renderable] = {}
        self._shown: set[tuple[int, str]] = set()
        self._add_ambient_light()
        self._table = self._renderable(table, *self._upload(table), label=0)
        self._scene.add_renderable(self._table)

    def rgb(self, objects: Iterable[PlacedObject], camera: Camera) -> Array:
        """Colour picture, uint8, shape (h, w, 3)."""
        self._place(objects)
        picture = _canvas(camera, (3,), np.uint8)
        self._read(camera, picture, mjrf.DrawMode.DRAW_MODE_DEFAULT)
        return picture

    def labels(self, objects: Iterable[PlacedObject], camera: Camera) -> Array:
        """Instance numbers, int32, shape (h, w); 0 where no object is."""
        self._place(objects)
        code = _canvas(camera, (3,), np.uint8)
        self._read(camera, code, mjrf.DrawMode.DRAW_MODE_SEGMENTATION_BY_ID)
        return code.astype(np.int32) @ np.array([1, 256, 65536], dtype=np.int32)

    def depth(self, objects: Iterable[PlacedObject], camera: Camera) -> Array:
        """Planar depth in metres, float32, shape (h, w).

        Filament's depth is reversed: z = n f / (n + d (f - n)) for clipping distances n and f.
        """
        self._place(objects)
        reversed_z = _canvas(camera, (), np.float32)
        self._read(camera, reversed_z, mjrf.DrawMode.DRAW_MODE_DEPTH)
        return np.float32(NEAR * FAR) / (np.float32(NEAR) + reversed_z * np.float32(FAR - NEAR))

    def silhouette(self, item: PlacedObject, camera: Camera) -> Array:
        """Mask of one object standing alone, bool, shape (h, w)."""
        return self.labels([item], camera) == item.instance

    def _place(self, objects: Iterable[PlacedObject]) -> None:
        """Show exactly these objects at their poses."""
        wanted: set[tuple[int, str]] = set()
        for item in objects:
            key = (item.instance, item.object_id)
            wanted.add(key)
            if key not in self._renderables:
                mesh = self._meshes[item.object_id]
                parts = self._uploaded.get(item.object_id) or self._upload(mesh)
                self._uploaded[item.object_id] = parts
                self._renderables[key] = self._renderable(mesh, *parts, label=item.instance)
            position = np.array(item.pose.position, np.float32)
            rotation = item.pose.rotation.astype(np.float32).reshape(9)
            self._renderables[key].set_pose(position, rotation)
        for key in sorted(wanted - self._shown):
            self._scene.add_renderable(self._renderables[key])
        for key in sorted(self._shown - wanted):
            self._scene.remove_renderable(self._renderables[key])
        self._shown = wanted

    def _renderable(
        self, mesh: PackedMesh, geometry: mjrf.Mesh, texture: mjrf.Texture, label: int
    ) -> mjrf.Renderable:
        renderable = self._context.create_renderable(
            mjrf.RenderableParams(cast_shadow=True, receive_shadow=True)
        )
        renderable.set_mesh(geometry, 0, mesh.index_count)
        # Without highlights a surface shows its texture's own colour (mean error 1.4 of 255).
        renderable.set_material(
            mjrf.Material(
                color=[1, 1, 1, 1],
                color_texture=texture,
                specular=0.0,
                glossiness=0.0,
                segmentation_id=label,
            )
        )
        renderable.set_pose(np.zeros(3, np.float32), np.eye(3, dtype=np.float32).reshape(9))
        renderable.set_size(np.ones(3, np.float32))
        return renderable

    def _upload(self, mesh: PackedMesh) -> tuple[mjrf.Mesh, mjrf.Texture]:
        usage, kind = mjrf.VertexAttributeUsage, mjrf.VertexAttributeType
        config = mjrf.MeshConfig(
            max_vertices=mesh.vertex_count,
            max_indices=mesh.index_count,
            attributes=[
                mjrf.VertexAttribute(
                    usage.VERTEX_ATTRIBUTE_USAGE_POSITION, kind.VERTEX_ATTRIBUTE_TYPE_FLOAT3
                ),
                mjrf.VertexAttribute(
                    usage.VERTEX_ATTRIBUTE_USAGE_TANGENTS, kind.VERTEX_ATTRIBUTE_TYPE_FLOAT4
                ),
                mjrf.VertexAttribute(
                    usage.VERTEX_ATTRIBUTE_USAGE_UV, kind.VERTEX_ATTRIBUTE_TYPE_FLOAT2
                ),
            ],
            interleaved=True,
            index_type=mjrf.IndexType.INDEX_TYPE_U32,
            primitive_type=mjrf.MeshPrimitiveType.MESH_PRIMITIVE_TYPE_TRIANGLES,
        )
        geometry = self._context.create_mesh(config)
        low, high = mesh.bounds
        data = mjrf.MeshData(compute_bounds=False, bounds_min=low, bounds_max=high)
        data.set_vertices(config, mesh.vertices)
        data.set_indices(config, mesh.indices)
        geometry.upload(data)
        self._alive += [config, data, geometry]
        pixels = mesh.surface.texture
        height, width = pixels.shape[:2]
        texture = self._texture(
            np.ascontiguousarray(pixels).tobytes(),
            (width, height),
            mjrf.PixelFormat.PIXEL_FORMAT_RGB8,
            mjrf.ColorSpace.COLORSPACE_SRGB,
        )
        return geometry, texture

    def _texture(
        self,
        content: bytes,
        size_px: tuple[int, int],
        layout: mjrf.PixelFormat,
        space: mjrf.ColorSpace,
    ) -> mjrf.Texture:
        texture = self._context.create_texture(
            mjrf.TextureConfig(
                width=size_px[0],
                height=size_px[1],
                format=layout,
                color_space=space,
                sampler_type=mjrf.SamplerType.TEXTURE_2D,
            )
        )
        data = mjrf.TextureData()
        data.set_image(content)
        texture.upload(data)
        self._alive += [data, texture]
        return texture

    def _add_ambient_light(self) -> None:
        environment = uniform_environment(AMBIENT_RADIANCE)
        texture = self._texture(
            environment,
            (len(environment), 0),
            mjrf.PixelFormat.PIXEL_FORMAT_KTX,
            mjrf.ColorSpace.COLORSPACE_LINEAR,
        )
        light = self._context.create_light(
            mjrf.LightParams(
                type=mjrf.LightType.LIGHT_IMAGE, texture=texture, intensity=UNIT_INTENSITY
            )
        )
        self._scene.add_light(light)
        self._alive.append(light)

    def _read(self, camera: Camera, canvas: Array, mode: mjrf.DrawMode) -> None:
        """Draw one frame into a C-contiguous array."""
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
            camera=_filament_camera(camera),
            target=target,
            draw_mode=mode,
            reflections=False,
            haze=False,
            skybox=False,
        )
        request.viewport.width = camera.width_px
        request.viewport.height = camera.height_px
        reading = mjrf.ReadRequest(target=target)
        reading.set_buffer(canvas)
        self._context.wait_for_frame(self._context.render([request], [reading]))


def _canvas(camera: Camera, channels: tuple[int, ...], dtype: type[np.generic]) -> Array:
    return np.zeros((camera.height_px, camera.width_px, *channels), dtype)


def _filament_camera(camera: Camera) -> mjrf.Camera:
    rotation = camera.world_from_camera.rotation
    top = NEAR * camera.height_px / 2 / camera.focal_px
    return mjrf.Camera(
        pos=np.array(camera.world_from_camera.position, np.float32),
        forward=rotation[:, 2].astype(np.float32),
        up=-rotation[:, 1].astype(np.float32),
        frustum_center=0.0,
        frustum_width=top * camera.width_px / camera.height_px,
        frustum_bottom=-top,
        frustum_top=top,
        frustum_near=NEAR,
        frustum_far=FAR,
        orthographic=False,
    )
