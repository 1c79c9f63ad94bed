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
_PROBES, _MOST_AT_ONCE = 4, 4.0
_AGAIN = 0.5
_IDLE = 1.0


@dataclass(frozen=True, eq=False)
class MotionPicture:
    """What a camera saw while the robot moved.

    Attributes:
        rgb: uint8, shape (n, n, 3).
        stamp: When, by the robot's clock, seconds.
        joints: The arm's then, radians.
        moved: For how many seconds the robot had moved in all when the picture was asked for.
    """

    rgb: Array
    stamp: float
    joints: tuple[float, ...]
    moved: float


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
        self._finest = min(_COARSEST, max(1, math.ceil(min(seen.width, seen.height) / EDGE_PX)))
        self._step = self._finest
        self._moves = threading.Event()
        self._counting = threading.Lock()
        self._moved, self._since = 0.0, 0.0
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
        with self._counting:
            self._since = time.monotonic()
            self._moves.set()
        try:
            yield
        finally:
            with self._counting:
                self._moved = self._moved_by(time.monotonic())
                self._moves.clear()

    def _run(self) -> None:
        self._measure()
        while self._client.open and self._failed is None:
            if not self._moves.wait(_IDLE):
                continue
            asked = time.monotonic()
            with self._counting:
                moved = self._moved_by(asked)
            seen, link = self._look()
            if seen is not None:
                self._take(seen, moved)
                self._adapt(link)
            spent = time.monotonic() - asked
            time.sleep(max(0.0, 1 / RATE - spent, link * (1 / SHARE - 1)))

    def _measure(self) -> None:
        """Make pictures as small as the link needs them, while nothing moves yet."""
        for _ in range(_PROBES):
            seen, link = self._look()
            if seen is None or link <= SLOW:
                return
            smaller = math.sqrt(min(_MOST_AT_ONCE, link / SLOW))
            self._step = min(_COARSEST, math.ceil(self._step * smaller))

    def _adapt(self, link: float) -> None:
        """Make pictures a little smaller or larger, by how long the last one was on the link."""
        if link > SLOW:
            self._step = min(_COARSEST, self._step + 1)
        elif link < SLOW / 4:
            self._step = max(self._finest, self._step - 1)

    def _moved_by(self, now: float) -> float:
        """Seconds for which the robot has moved until now, in all."""
        return self._moved + (max(0.0, now - self._since) if self._moves.is_set() else 0.0)

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
        return seen, time.monotonic() - asked - seen.took

    def _take(self, seen: GlimpsePicture, moved: float) -> None:
        try:
            self._keep(MotionPicture(self._straight(seen), seen.stamp, seen.joints, moved))
        except ProbeError as error:
            self._failed = error

    def _straight(self, seen: GlimpsePicture) -> Array:
        """As a frame of the same camera shows it, though smaller."""
        small = seen.camera
        if small.width not in self._maps:
            edge = min(small.width, small.height)
            self._maps[small.width] = Straightened.of(small, edge)
        return self._maps[small.width].colours(seen.rgb)
