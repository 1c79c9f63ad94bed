"""What the bridge asks of a robot. Drivers know no protocol, no limits and no clients."""

from __future__ import annotations

from typing import NamedTuple, Optional, Protocol

from probe_bridge.curve import Row
from probe_bridge.trajectory import Trajectory


class Reading(NamedTuple):
    """Joint angles in the config's order, radians, and when they were measured.

    Times are of time.monotonic() on the robot's computer.
    """

    joints: Row
    stamp: float


class Shot(NamedTuple):
    """What a camera saw.

    Attributes:
        width, height: Pixels.
        depth: Planar depth, uint16, little-endian, row by row; 0 where there is none.
        depth_unit: Metres that one step of the depth stands for.
        rgb: Three bytes a pixel, or None where nobody asked for it.
        stamp: When it was taken, time.monotonic() of the robot's computer.
    """

    width: int
    height: int
    depth: bytes
    depth_unit: float
    rgb: Optional[bytes]
    stamp: float


class Driver(Protocol):
    """A robot's own interface, made alike.

    The bridge calls it from several threads: never two of start() and poll() at once, but stop(),
    joints(), opening() and frame() at any moment. What a method raises stops a robot that moves,
    unless it was only asked to look.
    """

    def joints(self) -> Reading:
        """The newest measured angles; doesn't wait for new ones."""
        ...

    def opening(self) -> float:
        """How far the hand is open, as measured, metres."""
        ...

    def frame(self, camera: str, rgb: bool) -> Shot:
        """A picture taken after this call; may wait for it, at most a second or two."""
        ...

    def start(self, trajectory: Trajectory) -> None:
        """Begin a checked motion from where the arm is; returns at once."""
        ...

    def poll(self) -> bool:
        """Whether the motion that was started has ended.

        Raises:
            Exception: The robot gave it up.
        """
        ...

    def start_grip(self, opening: float) -> None:
        """Begin to open or close the hand towards metres; returns at once."""
        ...

    def poll_grip(self) -> bool:
        """Whether the hand has come to rest, there or on something that it holds."""
        ...

    def stop(self) -> None:
        """Bring arm and hand to rest at once; nothing moves until the next start."""
        ...

    def close(self) -> None:
        """Let go of the robot's interface."""
        ...
