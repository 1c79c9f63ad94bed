"""One arm, one table, a camera over it and one over the basket; simulated or real.

This is the only thing that tells simulation and robot apart.

Skills are written once over this. Nothing here says what stands on the table: a skill sees a
Frame, moves the arm and feels how far the gripper closed.
"""

from __future__ import annotations

from typing import Protocol

from probe.types import Array, Frame, Pose


class Hand(Protocol):
    """The gripper's shape, in the arm's tool frame: z out of the hand, closing along y."""

    max_opening: float
    pad_half: tuple[float, float, float]

    def pad_reach(self, opening: float) -> float:
        """Distance along z from the tool frame to the middle of the pads, metres."""
        ...

    def boxes(self, opening: float) -> list[tuple[Array, Array]]:
        """Centres and half sizes, shape (3,), of boxes that enclose the hand, tool frame."""
        ...


class Arm(Protocol):
    """The arm's kinematics."""

    parked: Array
    """Joint angles, shape (n,), at which the camera's view is free of the arm."""

    endless: tuple[int, ...]
    """Joints, counted from 0, that may take whole turns on the way; others would run into stops."""

    at_hand: int
    """How many of the spheres, the last ones, cover the link that the hand turns on."""

    def inverse(self, world_from_tool: Pose) -> list[Array]:
        """Joint angles, each of shape (n,), that reach a tool pose; empty out of reach."""
        ...

    def forward(self, joints: Array) -> Pose:
        """world_from_tool of joint angles, shape (n,)."""
        ...

    def spheres(self, joints: Array) -> Array:
        """Spheres that cover the arm without its hand: x, y, z, radius, shape (k, 4), metres."""
        ...


class Station(Protocol):
    """A table that can be looked at and reached."""

    arm: Arm
    hand: Hand

    def observe(self, *, rgb: bool) -> Frame:
        """Look at the table with the fixed camera.

        Raises:
            ArmInView: The arm isn't parked, so it would hide part of the table.
        """
        ...

    def look_into_basket(self, *, rgb: bool) -> Frame:
        """Look into the basket with the camera above it.

        Raises:
            ArmInView: The arm isn't parked.
        """
        ...

    def joints(self) -> Array:
        """Joint angles as measured, radians, shape (n,)."""
        ...

    def follow(self, path: Array) -> bool:
        """Move through joint angles, shape (m, n), in one smooth motion, and come to rest.

        Returns:
            Whether the arm got there. It stops where it is as soon as something holds it back.
        """
        ...

    def grip(self, opening: float) -> float:
        """Open or close the gripper towards an opening in metres, and say what it reached."""
        ...

    def wait(self, seconds: float) -> None:
        """Let things come to rest, at most so many seconds."""
        ...
