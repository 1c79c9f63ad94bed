"""Pictures of an arm in motion, for a film. Nothing that moves the arm waits for them."""

from __future__ import annotations

import math
import threading
import time
from collections.abc import Callable, Generator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from typing import TYPE_CHECKING

from probe.errors import ProbeError
from probe.station.straightened import Straightened
from probe.types import Array

if TYPE_CHECKING:
    from probe_bridge.client import RobotClient
    from probe_bridge.description import GlimpsePicture

RATE = 4.0
"""Pictures a second, where camera and link can give as many."""

EDGE_PX = 512
"""About the edge of the pictures: a film shows them hardly larger."""

SHARE = 0.25
"""Share of the time that the link may carry pictures, so that answers to leases get through."""

SLOW = 0.15
"""Seconds on the link after which pictures are made smaller: a lease lasts 0.5."""

_COARSEST = 16
_AGAIN = 0.5
_IDLE = 1.0


@dataclass(frozen=True, eq=False)
class MotionPicture:
    """What a camera saw while the robot moved.

    Attributes:
        rgb: uint8, shape (n, n, 3).
        stamp: When, by the robot's clock, seconds.
        joints: The arm's then, radians.
    """

    rgb: Array
    stamp: float
    joints: tuple[float, ...]


Keep = Callable[[MotionPicture], None]
"""Keeps a picture; called in the camera's own thread, in order."""


class MotionCamera:
    """Takes a picture about RATE times a second while something moves, in a thread of its own.

    The pictures share the robot's connection. There is never more than one on its way, they come
    more rarely and smaller over a slow link, and whoever moves the robot never waits for one.

    Args:
        client: Connected to the robot's bridge.
        camera: Which of its cameras.
        keep: Gets each picture.
    """

    def __init__(self, client: RobotClient, camera: str, keep: Keep) -> None:
        self._client = client
        self._camera = camera
        self._keep = keep
        seen = client.description.cameras[camera]
        self._step = min(_COARSEST, max(1, math.ceil(min(seen.width, seen.height) / EDGE_PX)))
        self._moves = threading.Event()
        self._failed: ProbeError | None = None
        self._maps: dict[int, Straightened] = {}
        # What it waits for may never come, and nothing is lost with it.
        threading.Thread(target=self._run, name="film", daemon=True).start()

    @contextmanager
    def filming(self) -> Generator[None]:
        """Take pictures while the block lasts.

        Raises:
            OutputFailed: An earlier picture couldn't be kept; nothing has begun to move.
        """
        if self._failed is not None:
            raise self._failed
        self._moves.set()
        try:
            yield
        finally:
            self._moves.clear()

    def _run(self) -> None:
        # How fast the link is, is found out while nothing moves.
        self._look()
        while self._client.open and self._failed is None:
            if not self._moves.wait(_IDLE):
                continue
            asked = time.monotonic()
            seen, link = self._look()
            if seen is not None:
                self._take(seen)
            spent = time.monotonic() - asked
            time.sleep(max(0.0, 1 / RATE - spent, link * (1 / SHARE - 1)))

    def _look(self) -> tuple[GlimpsePicture | None, float]:
        """A picture if one came, and how many seconds it was on the link."""
        from probe_bridge.errors import BridgeError

        asked = time.monotonic()
        try:
            seen = self._client.glimpse(self._camera, self._step)
        except BridgeError as error:
            # A film with a gap is worth more than an episode that ends for the film's sake.
            with suppress(BridgeError):  # a log that can't be written refuses the next motion
                self._client.log.add("not filmed", why=str(error))
            return None, _AGAIN
        link = time.monotonic() - asked - seen.took
        if link > SLOW:
            self._step = min(_COARSEST, math.ceil(self._step * math.sqrt(link / SLOW)))
        return seen, link

    def _take(self, seen: GlimpsePicture) -> None:
        try:
            self._keep(MotionPicture(self._straight(seen), seen.stamp, seen.joints))
        except ProbeError as error:
            self._failed = error

    def _straight(self, seen: GlimpsePicture) -> Array:
        """As a frame of the same camera shows it, though smaller."""
        small = seen.camera
        if small.width not in self._maps:
            edge = min(small.width, small.height)
            self._maps[small.width] = Straightened.of(small, edge)
        return self._maps[small.width].colours(seen.rgb)
