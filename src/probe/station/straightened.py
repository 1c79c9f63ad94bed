"""A real camera's picture as one of the pinhole cameras that all else knows: square, centred."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from scipy import ndimage

from probe.errors import BadData
from probe.types import Array, Camera, Pose

if TYPE_CHECKING:
    from probe_bridge.config import BridgeCamera
    from probe_bridge.description import Picture

_LEAST = 0.05
"""Tangent of half a field of view below which a camera's figures can't be right: 6 degrees."""


@dataclass(frozen=True, eq=False)
class Straightened:
    """Where to look in a camera's pictures for each pixel of a square, centred one.

    Attributes:
        camera: The square one. It stands where the real one does and sees the largest square
            around its principal point.
        rows, columns: Places in the real picture, pixels, each of shape (n, n); the middle of
            its top left pixel is (0, 0).
        shape: Height and width of the real pictures.
    """

    camera: Camera
    rows: Array
    columns: Array
    shape: tuple[int, int]

    @staticmethod
    def of(seen: BridgeCamera, size_px: int) -> Straightened:
        """The map for a camera.

        Args:
            seen: As its robot's bridge describes it.
            size_px: Edge of the square pictures.

        Raises:
            BadData: Its principal point lies outside its picture, or at the very edge.
        """
        sides = (
            seen.cx / seen.fx,
            (seen.width - seen.cx) / seen.fx,
            seen.cy / seen.fy,
            (seen.height - seen.cy) / seen.fy,
        )
        if min(sides) < _LEAST:
            raise BadData(
                f"camera {seen.name}",
                f"its principal point ({seen.cx:.1f}, {seen.cy:.1f}) leaves no picture around it",
                "Calibrate it again, and correct the robot's file",
            )
        half = min(sides)
        tangents = (np.arange(size_px) + 0.5 - size_px / 2) * (2 * half / size_px)
        pose = Pose(seen.position, seen.wxyz)
        camera = Camera(pose, size_px, size_px, math.degrees(2 * math.atan(half)))
        rows, columns = tangents * seen.fy + seen.cy - 0.5, tangents * seen.fx + seen.cx - 0.5
        return Straightened(
            camera,
            np.repeat(rows[:, None], size_px, axis=1),
            np.repeat(columns[None], size_px, axis=0),
            (seen.height, seen.width),
        )

    def depth(self, picture: Picture) -> Array:
        """Planar depth, metres, float32, shape (n, n); 0 where the camera has none.

        Each pixel's is the nearest one's: between two depths lies nothing.
        """
        raw = np.frombuffer(picture.depth, "<u2").reshape(self.shape)
        rows = np.clip(np.rint(self.rows), 0, self.shape[0] - 1).astype(int)
        columns = np.clip(np.rint(self.columns), 0, self.shape[1] - 1).astype(int)
        return (raw[rows, columns] * picture.depth_unit).astype(np.float32)

    def rgb(self, picture: Picture) -> Array:
        """Colours, sRGB uint8, shape (n, n, 3), of a picture that has them."""
        assert picture.rgb is not None
        return self.colours(picture.rgb)

    def colours(self, pixels: bytes) -> Array:
        """The same of a picture's pixels, three bytes each, row by row."""
        raw = np.frombuffer(pixels, np.uint8).reshape(*self.shape, 3)
        places = np.stack([self.rows, self.columns])
        channels = [
            ndimage.map_coordinates(raw[..., k].astype(np.float32), places, order=1, mode="nearest")
            for k in range(3)
        ]
        return np.rint(np.stack(channels, axis=-1)).astype(np.uint8)
