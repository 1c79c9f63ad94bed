"""The primitive solids that the robot is made of. Knows no engine and no particular robot."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from probe.types import Array, Vector3

Colour = tuple[float, float, float]

SILVER: Colour = (0.72, 0.74, 0.77)
GREY: Colour = (0.42, 0.44, 0.47)
BLUE: Colour = (0.33, 0.57, 0.75)
BLACK: Colour = (0.09, 0.09, 0.10)
RUBBER: Colour = (0.22, 0.22, 0.23)


@dataclass(frozen=True)
class Cylinder:
    """A cylinder, or capsule if rounded, between two points of its link's frame, metres."""

    start: Vector3
    end: Vector3
    radius: float
    colour: Colour
    rounded: bool = False


@dataclass(frozen=True)
class SolidBox:
    """A box along the axes of its link's frame, metres."""

    centre: Vector3
    half_size: Vector3
    colour: Colour

    @property
    def corners(self) -> Array:
        """Shape (8, 3)."""
        signs = np.array(np.meshgrid([-1, 1], [-1, 1], [-1, 1])).reshape(3, 8).T
        return np.asarray(self.centre) + signs * np.asarray(self.half_size)


def cylinder_inertia(mass: float, radius: float, length: float, axis: int) -> Array:
    """Principal inertia of a solid cylinder along axis 0, 1 or 2, kg m^2, shape (3,)."""
    inertia = np.full(3, mass * (3 * radius**2 + length**2) / 12)
    inertia[axis] = mass * radius**2 / 2
    return inertia


def box_inertia(mass: float, half_size: Vector3) -> Array:
    """Principal inertia of a solid box along its axes, kg m^2, shape (3,)."""
    squares = np.square(half_size)
    return mass / 3 * (squares.sum() - squares)
