"""A timed motion: what a driver is given to carry out."""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass
from typing import List, Tuple

from probe_bridge.curve import Row


@dataclass(frozen=True)
class Trajectory:
    """Joint angles over time, at rest at both ends.

    Attributes:
        times: Seconds from the start, rising from 0.
        joints: Radians at these times.
        velocities: Radians a second at these times.
    """

    times: Tuple[float, ...]
    joints: Tuple[Row, ...]
    velocities: Tuple[Row, ...]

    @property
    def duration(self) -> float:
        """Seconds."""
        return self.times[-1]

    def at(self, time: float) -> Tuple[Row, Row]:
        """Joint angles and velocities at a time; before and after it they are at rest."""
        rest = (0.0,) * len(self.joints[0])
        if time <= 0.0 or len(self.times) == 1:
            return self.joints[0], rest
        if time >= self.duration:
            return self.joints[-1], rest
        i = bisect_right(self.times, time) - 1
        h = self.times[i + 1] - self.times[i]
        u = time - self.times[i]
        angles: List[float] = []
        speeds: List[float] = []
        for a, b, m, n in zip(
            self.joints[i], self.joints[i + 1], self.velocities[i], self.velocities[i + 1]
        ):
            d = (b - a) / h
            c = (3 * d - 2 * m - n) / h
            e = (m + n - 2 * d) / (h * h)
            angles.append(a + u * (m + u * (c + u * e)))
            speeds.append(m + u * (2 * c + u * 3 * e))
        return tuple(angles), tuple(speeds)

    def slowed(self, factor: float) -> Trajectory:
        """The same motion in so many times its time."""
        times = tuple(time * factor for time in self.times)
        velocities = tuple(tuple(v / factor for v in row) for row in self.velocities)
        return Trajectory(times, self.joints, velocities)

    def every(self, period: float) -> List[Tuple[float, Row, Row]]:
        """Time, angles and velocities at equal distances in time, the end among them."""
        count = max(1, round(self.duration / period))
        times = [self.duration * i / count for i in range(1, count + 1)]
        return [(time, *self.at(time)) for time in times]
