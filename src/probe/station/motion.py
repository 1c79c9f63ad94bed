"""Smooth timing of a joint path. Knows no arm."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.interpolate import PchipInterpolator

from probe.types import Array

_PEAK = 1.875
"""Peak over mean speed of a minimum-jerk motion (Flash and Hogan, J. Neurosci. 5(7), 1985)."""


@dataclass(frozen=True, eq=False)
class Trajectory:
    """Joint angles and velocities at each time step, shapes (m, n), radians and radians/s."""

    joints: Array
    velocities: Array


def smooth(path: Array, peak_speed: float, time_step: float) -> Trajectory:
    """Time a path from rest to rest; no joint is ever faster than the peak speed.

    The path's length is measured in the joint that moves most; along it runs a minimum-jerk
    profile, and a monotone cubic through the waypoints never overshoots any of them.

    Args:
        path: Waypoints, shape (m, n), radians; repeated ones are skipped.
        peak_speed: Radians a second.
        time_step: Seconds.
    """
    moves = np.abs(np.diff(path, axis=0)).max(axis=1)
    kept = path[np.concatenate([[True], moves > 1e-9])]
    if len(kept) == 1:
        return Trajectory(kept, np.zeros_like(kept))
    length = np.concatenate([[0.0], np.cumsum(np.abs(np.diff(kept, axis=0)).max(axis=1))])
    curve = PchipInterpolator(length, kept)
    # The cubic may be steeper than its chords; measure that and slow down accordingly.
    steepest = float(np.abs(curve(np.linspace(0, length[-1], 400), 1)).max())
    duration = _PEAK * length[-1] * steepest / peak_speed
    count = max(2, int(np.ceil(duration / time_step)) + 1)
    t = np.linspace(0.0, 1.0, count)
    along = length[-1] * t**3 * (10 - 15 * t + 6 * t**2)
    rate = length[-1] * 30 * t**2 * (1 - t) ** 2 / ((count - 1) * time_step)
    return Trajectory(curve(along), curve(along, 1) * rate[:, None])
