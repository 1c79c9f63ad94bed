"""A client's permission to move, which lapses unless it is renewed. Knows no robot."""

from __future__ import annotations

import math
from typing import Callable

LEASE = 0.5
"""Seconds that a renewal lasts, by the robot's clock."""

FRESH = 0.5
"""Seconds that may lie between a reply and a request that builds on it: longer, and the client
acts on what the robot was, and its stop would come as late."""


class Lease:
    """How long something may still move.

    Args:
        clock: Seconds; the robot's own, as a client's clock may be wrong.
    """

    def __init__(self, clock: Callable[[], float]) -> None:
        self._clock = clock
        self._until = 0.0

    def renew(self) -> None:
        self._until = self._clock() + LEASE

    def age(self, seen: float) -> float:
        """Seconds since the clock was so; infinite if it has never been."""
        now = self._clock()
        return now - seen if seen <= now else math.inf

    @property
    def left(self) -> float:
        """Seconds until it lapses; not above 0 once it has."""
        return self._until - self._clock()
