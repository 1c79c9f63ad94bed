"""Blender's own objects, made from plain values: meshes, images, materials, world, sun, camera.

Runs in Blender's process only.
"""

from __future__ import annotations

import math
from typing import Any

import bpy
import numpy as np

from probe.assets.mesh.mesh import Material, TexturedMesh
from probe.render.illumination import Illumination, Sun
from probe.types import Array, Camera, Pose

NEAR, FAR = 0.05, 20.0
"""Clipping distances in metres; a series says how far it sees."""

_SUN_SIZE_DEG = 4.0
"""Apparent diameter of the sun: what makes shadows soft."""

_BACKGROUND = 0.55
"""Linear grey behind the table where there is no backdrop, as Filament has it."""

_METAL = 0.6
"""How much like a mirror bare metal is, as Filament has it."""

_OPENCV_FROM_BLENDER = Pose((0.0, 0.0, 0.0), (0.0, 1.0, 0.0, 0.0))
"""Blender's cameras look along -z with y upwards."""


def mesh_of(name: str, mesh: TexturedMesh, *, glossy: bool) -> bpy.types.Mesh:
    """A mesh with its normals, texture coordinates and material."""
    made = bpy.data.meshes.new(name)
    faces = mesh.faces.astype(np.int32)
    made.vertices.add(len(mesh.vertices))
    made.vertices.foreach_set("co", mesh.vertices.astype(np.float32).ravel())
    made.loops.add(faces.size)
    made.loops.foreach_set("vertex_index", faces.ravel())
    made.polygons.add(len(faces))
    made.polygons.foreach_set("loop_start", np.arange(0, faces.size, 3, dtype=np.int32))
    # Images are handed over top row first, so v counts from the top here as well.
    made.uv_layers.new().uv.foreach_set("vector", mesh.uvs[faces].astype(np.float32).ravel())
    made.update(calc_edges=True)
    made.normals_split_custom_set_from_vertices(mesh.normals.tolist())
    made.materials.append(_material(name, mesh.surface, glossy=glossy))
    return made


def _material(name: str, surface: Material, *, glossy: bool) -> bpy.types.Material:
    material, tree = _shader(bpy.data.materials.new(name))
    colour = _texture(tree, surface.texture, "sRGB")
    end = tree.nodes.new("ShaderNodeOutputMaterial").inputs["Surface"]
    if not glossy:
        # Without highlights a surface shows its texture's own colour.
        diffuse = tree.nodes.new("ShaderNodeBsdfDiffuse")
        tree.links.new(colour, diffuse.inputs["Color"])
        tree.links.new(diffuse.outputs["BSDF"], end)
        return material
    bsdf = tree.nodes.new("ShaderNodeBsdfPrincipled")
    tree.links.new(colour, bsdf.inputs["Base Color"])
    bsdf.inputs["Metallic"].default_value = _METAL * surface.metallic
    bsdf.inputs["Roughness"].default_value = surface.roughness
    if surface.roughness_map is not None:
        rough = _texture(tree, surface.roughness_map, "Non-Color")
        tree.links.new(rough, bsdf.inputs["Roughness"])
    if surface.normal is not None:
        bump = tree.nodes.new("ShaderNodeNormalMap")
        tree.links.new(_texture(tree, surface.normal, "Non-Color"), bump.inputs["Color"])
        tree.links.new(bump.outputs["Normal"], bsdf.inputs["Normal"])
    tree.links.new(bsdf.outputs["BSDF"], end)
    return material


def world_of(light: Illumination) -> bpy.types.World:
    """What lights everything from far away; the camera sees the backdrop instead."""
    world, tree = _shader(bpy.data.worlds.new("light"))
    world.sun_threshold = 0.0  # the sun has been taken out of the panorama already
    lit = tree.nodes.new("ShaderNodeBackground")
    tree.links.new(_panorama(tree, light.radiance), lit.inputs["Color"])
    seen = tree.nodes.new("ShaderNodeBackground")
    seen.inputs["Color"].default_value = (_BACKGROUND, _BACKGROUND, _BACKGROUND, 1.0)
    if light.backdrop is not None:
        tree.links.new(_panorama(tree, light.backdrop), seen.inputs["Color"])
    choice = tree.nodes.new("ShaderNodeMixShader")
    path = tree.nodes.new("ShaderNodeLightPath")
    tree.links.new(path.outputs["Is Camera Ray"], choice.inputs[0])
    tree.links.new(lit.outputs[0], choice.inputs[1])
    tree.links.new(seen.outputs[0], choice.inputs[2])
    end = tree.nodes.new("ShaderNodeOutputWorld").inputs["Surface"]
    tree.links.new(choice.outputs[0], end)
    return world


def sun_of(sun: Sun) -> bpy.types.Object:
    """Light from one direction. Blender's strength is an irradiance; a Sun's is that over pi."""
    strength, angle = max(sun.irradiance), math.radians(_SUN_SIZE_DEG * sun.size)
    lamp: Any = bpy.data.lights.new("sun", "SUN" if sun.distance is None else "AREA")
    lamp.color = [channel / strength for channel in sun.irradiance]
    place = np.zeros(3)
    if sun.distance is None:
        lamp.energy = math.pi * strength
        lamp.angle = angle
    else:
        # What a disc radiates by Lambert's law, over pi and the square of the distance, arrives.
        lamp.energy = (math.pi * sun.distance) ** 2 * strength
        lamp.shape = "DISK"
        lamp.size = 2 * sun.distance * math.tan(angle / 2)
        place = sun.distance * np.array(sun.towards)
    made = bpy.data.objects.new("sun", lamp)
    made.matrix_world = _facing(np.array(sun.towards), place)
    return made


def camera_of(camera: Camera, far: float) -> bpy.types.Object:
    """A pinhole camera that sees so many metres."""
    lens = bpy.data.cameras.new("camera")
    lens.sensor_fit = "VERTICAL"
    lens.angle_y = math.radians(camera.fov_y_deg)
    lens.clip_start, lens.clip_end = NEAR, far
    made = bpy.data.objects.new("camera", lens)
    made.matrix_world = (camera.world_from_camera @ _OPENCV_FROM_BLENDER).matrix.T.tolist()
    return made


def _facing(towards: Array, place: Array) -> list[list[float]]:
    """A pose, as Blender takes matrices (by columns), that turns +z towards a unit vector."""
    aside = np.cross((0.0, 1.0, 0.0) if abs(towards[1]) < 0.9 else (1.0, 0.0, 0.0), towards)
    aside /= np.linalg.norm(aside)
    matrix = np.eye(4)
    matrix[:3, 0], matrix[:3, 1], matrix[:3, 2] = aside, np.cross(towards, aside), towards
    matrix[:3, 3] = place
    return matrix.T.tolist()


def _shader(block: Any) -> tuple[Any, Any]:
    """A material or world and its emptied node tree."""
    block.use_nodes = True
    block.node_tree.nodes.clear()
    return block, block.node_tree


def _texture(tree: Any, pixels: Array, space: str) -> Any:
    """The colour output of a texture node."""
    height, width = pixels.shape[:2]
    rgba = np.ones((height, width, 4), np.float32)
    rgba[..., :3] = (pixels if pixels.ndim == 3 else pixels[..., None]) / np.float32(255)
    image = bpy.data.images.new("texture", width, height)
    image.colorspace_settings.name = space
    image.pixels.foreach_set(rgba.ravel())
    node = tree.nodes.new("ShaderNodeTexImage")
    node.image = image
    return node.outputs["Color"]


def _panorama(tree: Any, radiance: Array) -> Any:
    """The colour output of a panorama's node.

    Blender's panoramas have +x in the middle and the lowest row first; ours +y and the highest.
    """
    height, width = radiance.shape[:2]
    rgba = np.ones((height, width, 4), np.float32)
    rgba[..., :3] = np.roll(radiance[::-1], -(width // 4), axis=1)
    image = bpy.data.images.new("panorama", width, height, float_buffer=True)
    image.pixels.foreach_set(rgba.ravel())
    node = tree.nodes.new("ShaderNodeTexEnvironment")
    node.image = image
    return node.outputs["Color"]
