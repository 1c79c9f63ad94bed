"""Where the arm's points are at given joint angles: the bridge's own forward kinematics."""

from __future__ import annotations

from dataclasses import dataclass
from typing import List, Sequence, Tuple

from probe_bridge.fields import Vector
from probe_bridge.geometry import Transform, about, apply, compose


@dataclass(frozen=True)
class Joint:
    """A turning joint as in a URDF, with its limits.

    Attributes:
        name: As the driver knows it.
        origin: parent_from_joint at angle zero.
        axis: Unit vector in the joint's frame.
        lower, upper: Radians.
        speed: Radians a second, at most.
        acceleration: Radians a second squared, at most.
    """

    name: str
    origin: Transform
    axis: Vector
    lower: float
    upper: float
    speed: float
    acceleration: float


@dataclass(frozen=True)
class Chain:
    """An arm from its mount to its tool.

    Attributes:
        mount: world_from_base.
        joints: From the base outwards.
        tool: last_link_from_tool.
        points: Further points to watch: after how many joints, and where in that link's frame.
    """

    mount: Transform
    joints: Tuple[Joint, ...]
    tool: Transform
    points: Tuple[Tuple[int, Vector], ...]

    def links(self, angles: Sequence[float]) -> List[Transform]:
        """world_from_link of the base and of each link after it."""
        frames = [self.mount]
        for joint, angle in zip(self.joints, angles):
            turn = Transform(about(joint.axis, angle), (0.0, 0.0, 0.0))
            frames.append(compose(compose(frames[-1], joint.origin), turn))
        return frames

    def watched(self, angles: Sequence[float]) -> List[Vector]:
        """The tool and then the further points, in the world, metres."""
        links = self.links(angles)
        tool = apply(links[-1], self.tool.position)
        return [tool, *(apply(links[after], point) for after, point in self.points)]
