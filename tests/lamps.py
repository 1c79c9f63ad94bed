"""Light of one lamp, and how dark the table is around what stands in it."""

import math

import numpy as np

from probe.render.illumination import directions
from probe.render.sunlight import illuminate


def lamp(colour=(1.0, 1.0, 1.0), yaw=0.0):
    """Coloured surroundings with one bright lamp, 45 degrees up towards +x at yaw 0."""
    towards = directions(64)
    near = towards @ np.array([1, 0, 1]) / math.sqrt(2) > math.cos(math.radians(4))
    return illuminate(np.where(near[..., None], 80.0, 0.6) * np.array(colour), yaw)


def shades(frame, distance=0.07):
    """Mean brightness of the table beside the post: towards +x, -x, +y, -y."""
    step = round(distance / 0.58 * 256)
    spots = [(0, step), (0, -step), (-step, 0), (step, 0)]
    grey = frame.rgb.astype(float).mean(axis=2)
    return [grey[128 + v - 3 : 131 + v, 128 + u - 3 : 131 + u].mean() for v, u in spots]
