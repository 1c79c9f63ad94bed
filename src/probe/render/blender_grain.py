"""Keeps grain out of what EEVEE draws: more samples and rays to the light, then a denoiser.

Runs in Blender's process only.
"""

from __future__ import annotations

from typing import Any

import bpy

SAMPLES = 16
"""Of each pixel of a picture that may show no grain."""

_SHADOW_RAYS = 4
"""To each light, of each sample; Blender allows no more."""

_FILTER = 0.8
"""Width of a pixel's filter. Wider ones spread grain over neighbours, and Blender's denoiser takes
what neighbours share for texture."""


def keep_out_grain(scene: Any) -> None:
    """Have a scene drawn without grain in its shadows, at three times the cost."""
    scene.eevee.taa_render_samples = SAMPLES
    scene.eevee.shadow_ray_count = _SHADOW_RAYS
    scene.render.filter_size = _FILTER
    _denoise(scene)


def _denoise(scene: Any) -> None:
    """Denoise the drawn picture. Its colours and normals without light tell texture from grain."""
    layer: Any = scene.view_layers[0]
    layer.use_pass_normal = layer.use_pass_diffuse_color = True
    tree: Any = bpy.data.node_groups.new("denoised", "CompositorNodeTree")
    tree.interface.new_socket("Image", in_out="OUTPUT", socket_type="NodeSocketColor")
    drawn, denoiser = (tree.nodes.new(f"CompositorNode{kind}") for kind in ("RLayers", "Denoise"))
    end = tree.nodes.new("NodeGroupOutput")
    for made, taken in (("Image", "Image"), ("Normal", "Normal"), ("Diffuse Color", "Albedo")):
        tree.links.new(drawn.outputs[made], denoiser.inputs[taken])
    tree.links.new(denoiser.outputs["Image"], end.inputs[0])
    scene.compositing_node_group = tree
