"""Filament's own objects, made from packed values: meshes, textures, materials, lights, cameras.

Runs in a forked child only.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from mujoco import mjrf

from probe.assets.mesh.mesh import Material
from probe.render.illumination import Sun
from probe.render.packing import PackedMesh
from probe.types import Array, Camera

NEAR, FAR = 0.2, 4.0
"""Clipping distances in metres."""

_UNIT_INTENSITY = 39321.6
"""Intensity of an image light at which radiance 1 shows a surface in its own colour (measured)."""

_SUN_INTENSITY = 39321.6 * np.pi
"""Lux of a sun that does the same for a surface that faces it."""

_METAL = 0.6
"""How much like a mirror bare metal is: a whole one shows a dark ceiling, not its own colour."""

_SUN_RADIUS = 0.05
"""Of the bulb in metres: what makes shadows soft."""

_SUN_SIZE = math.radians(4)
"""Apparent diameter of a usual sun that isn't far away."""

_LAMPS = 10
"""So many small lamps stand for one wide light: each has sharp shadows, and all together soft."""

_LAMP_SHADOW_PX = 2048
"""Edge of the map of each one's shadows."""

_LIT = 1.0
"""Metres around the middle of the table that they light."""


@dataclass(frozen=True, eq=False)
class Uploaded:
    """A mesh and its material on the graphics device."""

    geometry: mjrf.Mesh
    index_count: int
    material: Mapping[str, object]


class Factory:
    """Makes parts within one Context, and keeps alive what Filament reads later.

    Filament reads from another thread and owns nothing it is given.

    Args:
        context: What they are made in.
        glossy: Whether surfaces have highlights.
        quick: Whether all suns are far away, and their shadows coarse.
    """

    def __init__(self, context: mjrf.Context, *, glossy: bool, quick: bool) -> None:
        self._context = context
        self._glossy = glossy
        self._quick = quick
        self._alive: list[object] = []

    def upload(self, mesh: PackedMesh) -> Uploaded:
        """Send a mesh and its base colour to the device."""
        config = _mesh_config(mesh)
        geometry = self._context.create_mesh(config)
        low, high = mesh.bounds
        data = mjrf.MeshData(compute_bounds=False, bounds_min=low, bounds_max=high)
        data.set_vertices(config, mesh.vertices)
        data.set_indices(config, mesh.indices)
        geometry.upload(data)
        self._alive += [config, data, geometry]
        return Uploaded(geometry, mesh.index_count, self._material(mesh.surface))

    def renderable(self, parts: Uploaded, label: int) -> mjrf.Renderable:
        """Something to show: at the origin until it is placed."""
        renderable = self._context.create_renderable(
            mjrf.RenderableParams(cast_shadow=True, receive_shadow=True)
        )
        renderable.set_mesh(parts.geometry, 0, parts.index_count)
        renderable.set_material(mjrf.Material(**parts.material, segmentation_id=label))
        renderable.set_pose(np.zeros(3, np.float32), np.eye(3, dtype=np.float32).reshape(9))
        renderable.set_size(np.ones(3, np.float32))
        return renderable

    def _material(self, surface: Material) -> dict[str, object]:
        colour = self._image(surface.texture, mjrf.ColorSpace.COLORSPACE_SRGB)
        material: dict[str, object] = {"color": [1, 1, 1, 1], "color_texture": colour}
        if not self._glossy:
            # Without highlights a surface shows its texture's own colour (mean error 1.4 of 255).
            return material | {"specular": 0.0, "glossiness": 0.0}
        linear = mjrf.ColorSpace.COLORSPACE_LINEAR
        material |= {"roughness": surface.roughness, "metallic": _METAL * surface.metallic}
        if surface.normal is not None:
            material["normal_texture"] = self._image(surface.normal, linear)
        if surface.roughness_map is not None:
            material |= {"roughness_texture": self._image(surface.roughness_map, linear)}
            material["roughness"] = 1.0
        return material

    def image_light(self, cube: bytes) -> mjrf.Light:
        """Light from all around, of a prefiltered cube map."""
        texture = self._cube(cube, mjrf.SamplerType.TEXTURE_2D)
        return self._light(
            mjrf.LightParams(
                type=mjrf.LightType.LIGHT_IMAGE, texture=texture, intensity=_UNIT_INTENSITY
            )
        )

    def sun(self, sun: Sun) -> list[mjrf.Light]:
        """What lights from one direction, with soft shadows."""
        if sun.distance is None or self._quick:
            return [self._parallel(sun)]
        return self._wide(sun, sun.distance)

    def _wide(self, sun: Sun, distance: float) -> list[mjrf.Light]:
        """Lamps on a disc that faces the table, evenly spread as the seeds of a sunflower are."""
        towards = np.array(sun.towards)
        aside = np.cross((0.0, 0.0, 1.0), towards) / np.hypot(*sun.towards[:2])
        across = np.stack([aside, np.cross(towards, aside)])
        number = np.arange(_LAMPS)
        turn, out = np.pi * (3 - np.sqrt(5)) * number, np.sqrt((number + 0.5) / _LAMPS)
        disc = np.stack([out * np.cos(turn), out * np.sin(turn)], axis=1)
        radius = distance * np.tan(_SUN_SIZE * sun.size / 2)
        return [self._lamp(sun, distance * towards + radius * place @ across) for place in disc]

    def _lamp(self, sun: Sun, place: Array) -> mjrf.Light:
        """One of those lamps; what it gives falls with the square of the distance."""
        strength, distance = max(sun.irradiance), float(np.linalg.norm(place))
        light = self._light(
            mjrf.LightParams(
                type=mjrf.LightType.LIGHT_SPOT,
                color=np.array(sun.irradiance, np.float32) / np.float32(strength),
                intensity=_SUN_INTENSITY * strength * distance**2 / _LAMPS,
                range=10 * distance,
                cutoff=math.degrees(math.asin(_LIT / distance)),
                cast_shadow=True,
                shadow_map_size=_LAMP_SHADOW_PX,
            )
        )
        light.set_pose(place.astype(np.float32), (-place / distance).astype(np.float32))
        return light

    def _parallel(self, sun: Sun) -> mjrf.Light:
        """Light of a sun that is far away."""
        strength = max(sun.irradiance)
        light = self._light(
            mjrf.LightParams(
                type=mjrf.LightType.LIGHT_DIRECTIONAL,
                color=np.array(sun.irradiance, np.float32) / np.float32(strength),
                intensity=_SUN_INTENSITY * strength,
                cast_shadow=True,
                shadow_map_size=1024 if self._quick else 2048,
                bulb_radius=_SUN_RADIUS * sun.size,
            )
        )
        towards = np.array(sun.towards, np.float32)
        light.set_pose(3 * towards, -towards)
        return light

    def backdrop(self, cube: bytes) -> mjrf.Texture:
        """What is seen where nothing is."""
        return self._cube(cube, mjrf.SamplerType.TEXTURE_CUBE)

    def _light(self, params: mjrf.LightParams) -> mjrf.Light:
        light = self._context.create_light(params)
        self._alive.append(light)
        return light

    def _image(self, pixels: Array, space: mjrf.ColorSpace) -> mjrf.Texture:
        height, width = pixels.shape[:2]
        grey, colour = mjrf.PixelFormat.PIXEL_FORMAT_R8, mjrf.PixelFormat.PIXEL_FORMAT_RGB8
        return self._texture(
            np.ascontiguousarray(pixels).tobytes(),
            mjrf.TextureConfig(
                width=width,
                height=height,
                format=grey if pixels.ndim == 2 else colour,
                color_space=space,
                sampler_type=mjrf.SamplerType.TEXTURE_2D,
            ),
        )

    def _cube(self, file: bytes, sampler: mjrf.SamplerType) -> mjrf.Texture:
        return self._texture(
            file,
            mjrf.TextureConfig(
                width=len(file),
                height=0,
                format=mjrf.PixelFormat.PIXEL_FORMAT_KTX,
                color_space=mjrf.ColorSpace.COLORSPACE_LINEAR,
                sampler_type=sampler,
            ),
        )

    def _texture(self, content: bytes, config: mjrf.TextureConfig) -> mjrf.Texture:
        texture = self._context.create_texture(config)
        data = mjrf.TextureData()
        data.set_image(content)
        texture.upload(data)
        self._alive += [data, texture]
        return texture


def _mesh_config(mesh: PackedMesh) -> mjrf.MeshConfig:
    usage, kind = mjrf.VertexAttributeUsage, mjrf.VertexAttributeType
    attributes = (
        (usage.VERTEX_ATTRIBUTE_USAGE_POSITION, kind.VERTEX_ATTRIBUTE_TYPE_FLOAT3),
        (usage.VERTEX_ATTRIBUTE_USAGE_TANGENTS, kind.VERTEX_ATTRIBUTE_TYPE_FLOAT4),
        (usage.VERTEX_ATTRIBUTE_USAGE_UV, kind.VERTEX_ATTRIBUTE_TYPE_FLOAT2),
    )
    return mjrf.MeshConfig(
        max_vertices=mesh.vertex_count,
        max_indices=mesh.index_count,
        attributes=[mjrf.VertexAttribute(*attribute) for attribute in attributes],
        interleaved=True,
        index_type=mjrf.IndexType.INDEX_TYPE_U32,
        primitive_type=mjrf.MeshPrimitiveType.MESH_PRIMITIVE_TYPE_TRIANGLES,
    )


def filament_camera(camera: Camera, far: float = FAR) -> mjrf.Camera:
    """A camera as Filament wants it: by its frustum, looking along -z; it sees so many metres."""
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
        frustum_far=far,
        orthographic=False,
    )
