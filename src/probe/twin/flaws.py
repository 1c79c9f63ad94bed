"""What real cameras do to a picture: noise, holes, steps, wrong places, late and lost frames."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from scipy import ndimage
from scipy.spatial.transform import Rotation

from probe.types import Array, Camera, Pose

_EDGE = 0.02
"""Step in depth between neighbouring pixels that makes an edge, metres."""


@dataclass(frozen=True)
class Flaws:
    """How bad the twin's cameras are; all zero is perfect.

    The figures are those of stereo cameras of the RealSense D400 kind at a metre: their depth's
    noise grows with the square of the distance (Intel, "Best-known methods for tuning D400").

    Attributes:
        depth_noise: Standard deviation of the depth at a distance of a metre, metres.
        depth_step: Depths are multiples of this, metres.
        holes: Share of pixels at edges in depth without a reading, 0 to 1.
        colour_noise: Standard deviation of each channel, of 255.
        shift: How far the camera stands from where its calibration says, metres.
        turn: By how much it is turned against that, radians.
        latency: How old a picture is when it comes, seconds.
        dropped: Share of pictures that are lost, so that the next one has to do.
    """

    depth_noise: float = 0.002
    depth_step: float = 0.0005
    holes: float = 0.5
    colour_noise: float = 3.0
    shift: float = 0.002
    turn: float = math.radians(0.5)
    latency: float = 0.06
    dropped: float = 0.02


NO_FLAWS = Flaws(0.0, 1e-4, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


def misplaced(camera: Camera, flaws: Flaws, rng: np.random.Generator) -> Camera:
    """Where a camera really is: off by the flaws' shift and turn in some direction."""
    way, axis = rng.standard_normal(3), rng.standard_normal(3)
    away = flaws.shift * way / np.linalg.norm(way)
    turned = Rotation.from_rotvec(flaws.turn * axis / np.linalg.norm(axis)).as_matrix()
    matrix = camera.world_from_camera.matrix.copy()
    matrix[:3, :3] = matrix[:3, :3] @ turned
    matrix[:3, 3] += away
    return replace(camera, world_from_camera=Pose.from_matrix(matrix))


def noisy_depth(depth: Array, flaws: Flaws, rng: np.random.Generator) -> Array:
    """A reading of planar depth, metres, shape (h, w): with noise, in steps, 0 in its holes."""
    spread = flaws.depth_noise * depth**2
    read = depth + spread * rng.standard_normal(depth.shape)
    read = np.rint(read / flaws.depth_step) * flaws.depth_step
    if flaws.holes:
        low, high = ndimage.minimum_filter(depth, 3), ndimage.maximum_filter(depth, 3)
        edge = high - low > _EDGE
        read = np.where(edge & (rng.random(depth.shape) < flaws.holes), 0.0, read)
    return read


def noisy_colours(rgb: Array, flaws: Flaws, rng: np.random.Generator) -> Array:
    """A picture with noise in each channel, uint8, shape (h, w, 3)."""
    read = rgb + flaws.colour_noise * rng.standard_normal(rgb.shape)
    return np.clip(np.rint(read), 0, 255).astype(np.uint8)
