"""What an arm is made of, as numbers: hinges in a row and a link around each. Knows no engine."""

from __future__ import annotations

from dataclasses import dataclass

from probe.types import Vector3
from probe.world.robot.solids import GREY, Colour, Cylinder


@dataclass(frozen=True)
class Hinge:
    """A joint with its servo, and how its link's frame lies in the one before.

    That frame is moved by `shift` along its x and turned about it by `twist`, then moved by `along`
    along the new z and turned about it by the joint's angle plus `offset`.

    Attributes:
        name: Of joint and servo.
        shift: Metres.
        twist: Radians.
        along: Metres.
        offset: Radians.
        limits: Smallest and largest angle, radians; None if it turns without end.
        torque: Largest, newton metres.
        stiffness: Of the servo, newton metres a radian.
        armature: Inertia of motor and gears at the joint, kg m^2.
    """

    name: str
    shift: float
    twist: float
    along: float
    offset: float
    limits: tuple[float, float] | None
    torque: float
    stiffness: float
    armature: float


@dataclass(frozen=True)
class Link:
    """What a hinge turns.

    Attributes:
        name: Of the body.
        mass: Kilograms.
        centre: Of mass, in the link's frame.
        barrel: Radius, length and axis of the cylinder that its inertia is taken from.
        solids: What collides and is seen.
    """

    name: str
    mass: float
    centre: Vector3
    barrel: tuple[float, float, int]
    solids: tuple[Cylinder, ...]


@dataclass(frozen=True)
class ArmBody:
    """An arm from its base to its flange.

    Attributes:
        base: What stands still, in the base frame.
        hinges: From the base outwards.
        links: What each of them turns.
        touching: Links that no motion can press together although the engine would see them touch.
        speed: Of the fastest joint, radians a second.
        flipped: Whether tool0 is the last link's frame turned by half a turn about its x axis, and
            not that frame itself.
        grip_force: Of its hand on each pad when nearly closed, newtons.
    """

    base: tuple[Cylinder, ...]
    hinges: tuple[Hinge, ...]
    links: tuple[Link, ...]
    touching: tuple[tuple[str, str], ...]
    speed: float
    flipped: bool
    grip_force: float


def housing(
    axis: int, start: float, end: float, radius: float, *, x: float = 0.0, colour: Colour = GREY
) -> Cylinder:
    """A cylinder along axis 1 (y) or 2 (z) of a link, displaced along its x."""
    ends: list[Vector3] = [
        (x, place, 0.0) if axis == 1 else (x, 0.0, place) for place in (start, end)
    ]
    return Cylinder(ends[0], ends[1], radius, colour)
