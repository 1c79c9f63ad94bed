"""Draws a planned motion over a picture of the table."""

from __future__ import annotations

import numpy as np
from PIL import Image, ImageDraw

from probe.station.station import Arm, Hand
from probe.types import Array, Camera, Frame

_STEP = 0.05
"""Radians between two points of the line, of the joint that moves most."""

_SHAPES = 3
"""Places along the way at which the arm's outline is drawn, the end among them."""

_LINE, _EDGE, _ARM = (255, 60, 0), (255, 255, 255), (90, 220, 255)


def path_picture(frame: Frame, arm: Arm, hand: Hand, path: Array) -> Array:
    """The frame's picture with the way of the fingertips, its end, and outlines of the arm.

    Args:
        frame: With colours; where it was taken from counts, not when.
        arm: That moves.
        hand: On it.
        path: Joint angles, shape (m, n), the first where the arm is.

    Returns:
        A picture of the same size, uint8, shape (h, w, 3).
    """
    assert frame.rgb is not None
    image = Image.fromarray(frame.rgb)
    pen = ImageDraw.Draw(image)
    width = max(1, image.height // 256)
    way = _dense(path)
    for number in range(1, _SHAPES + 1):
        _outline(pen, frame.camera, arm.spheres(way[(len(way) - 1) * number // _SHAPES]), width)
    tips = frame.camera.project(np.array([tip_of(arm, hand, joints) for joints in way]))
    shown = [(float(u), float(v)) for u, v in tips if np.isfinite((u, v)).all()]
    for colour, wide in ((_EDGE, 4 * width), (_LINE, 2 * width)):
        pen.line(shown, fill=colour, width=wide)
    for colour, wide in ((_EDGE, 4 * width), (_LINE, 2 * width)):
        for u, v in shown[-1:]:
            r = 6 * width
            pen.ellipse((u - r, v - r, u + r, v + r), outline=colour, width=wide)
    return np.asarray(image)


def tip_of(arm: Arm, hand: Hand, joints: Array) -> Array:
    """Where the fingertips of an open hand are, world, metres, shape (3,)."""
    reach = hand.pad_reach(hand.max_opening) + hand.pad_half[2]
    return arm.forward(joints).apply(np.array([[0.0, 0.0, reach]]))[0]


def _dense(path: Array) -> Array:
    """The path with points between its waypoints, shape (k, n)."""
    rows = [path[0]]
    for before, after in zip(path, path[1:], strict=False):
        count = max(1, int(np.ceil(np.abs(after - before).max() / _STEP)))
        rows += [before + (after - before) * i / count for i in range(1, count + 1)]
    return np.array(rows)


def _outline(pen: ImageDraw.ImageDraw, camera: Camera, spheres: Array, width: int) -> None:
    """Circles around the spheres that cover the arm."""
    local = camera.world_from_camera.inverse().apply(spheres[:, :3])
    for (u, v), depth, radius in zip(
        camera.project(spheres[:, :3]), local[:, 2], spheres[:, 3], strict=True
    ):
        if depth > radius:
            r = float(radius / depth * camera.focal_px)
            pen.ellipse((u - r, v - r, u + r, v + r), outline=_ARM, width=width)
