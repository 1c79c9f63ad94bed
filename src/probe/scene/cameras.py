"""Fixed cameras as data: where each stands, and how much it sees. Draws nothing."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Literal

import numpy as np

from probe.types import Camera, Pose, Vector3, looking_at

View = Literal["top", "front"]
"""A set-up's fixed cameras by name."""


@dataclass(frozen=True)
class CameraPlacement:
    """Where a fixed camera stands. World frame, metres.

    Attributes:
        eye: The camera's own place.
        target: The point that it looks at.
        fov_deg: Full field of view; pictures are square.
    """

    eye: Vector3
    target: Vector3
    fov_deg: float

    @staticmethod
    def above(height: float, width: float) -> CameraPlacement:
        """A camera so far above the table's middle that sees a square of so many metres."""
        fov = 2 * math.degrees(math.atan(width / 2 / height))
        return CameraPlacement((0.0, 0.0, height), (0.0, 0.0, 0.0), fov)

    @property
    def straight_down(self) -> bool:
        """Whether it looks along the vertical."""
        return self.eye[:2] == self.target[:2]

    @property
    def width(self) -> float:
        """What it sees across the middle of the picture at its target's distance, metres."""
        distance = float(np.linalg.norm(np.subtract(self.eye, self.target)))
        # To the micrometre, so that a width that was given comes back as it was.
        return round(2 * distance * math.tan(math.radians(self.fov_deg) / 2), 6)

    def camera(self, size_px: int) -> Camera:
        """The camera with square pictures of this size.

        The picture's right is world +x where it looks straight down or along +y; its top is
        then +y, or what is far off.
        """
        pose = Pose(self.eye, (0.0, 1.0, 0.0, 0.0))
        if not self.straight_down:
            pose = looking_at(np.array(self.eye), np.array(self.target))
        return Camera(pose, size_px, size_px, self.fov_deg)
