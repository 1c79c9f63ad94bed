"""All that the bridge knows of a robot: its arm, its limits, its cameras. Reads no file."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, Tuple

from probe_bridge.fields import Vector
from probe_bridge.kinematics import Chain


@dataclass(frozen=True)
class Box:
    """An upright box in the world, metres."""

    lower: Vector
    upper: Vector

    def outside(self, point: Vector) -> float:
        """How far a point is out of the box along the worst axis, metres; at most 0 inside."""
        return max(
            max(low - value, value - high)
            for value, low, high in zip(point, self.lower, self.upper)
        )


@dataclass(frozen=True)
class BridgeCamera:
    """A fixed pinhole camera: x right, y down, z forward; depth is registered to its picture.

    Attributes:
        name: As clients ask for it.
        width, height, fx, fy, cx, cy: Pixels; pixel centres lie at half-integers.
        position, wxyz: world_from_camera.
    """

    name: str
    width: int
    height: int
    fx: float
    fy: float
    cx: float
    cy: float
    position: Vector
    wxyz: Tuple[float, float, float, float]


@dataclass(frozen=True)
class Config:
    """All that the bridge has to know of a robot.

    Attributes:
        name, model: For people and records.
        chain: The arm.
        home: Joint angles at which no camera's view is hidden.
        tool_box: The box that the tool stays in.
        arm_box: The box that the further points stay in.
        tool_speed: Of the tool and of each further point, metres a second, at most.
        trail: By how much a joint may trail its plan before the arm stops, radians.
        delay: Seconds by which the arm may lag behind its plan; not counted as trailing.
        max_opening: How far the hand opens, metres.
        cameras: By name.
        options: What the driver reads, its own affair.
    """

    name: str
    model: str
    chain: Chain
    home: Tuple[float, ...]
    tool_box: Box
    arm_box: Box
    tool_speed: float
    trail: float
    delay: float
    max_opening: float
    cameras: Dict[str, BridgeCamera]
    options: Dict[str, Any]
