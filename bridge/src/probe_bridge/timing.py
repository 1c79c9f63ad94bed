"""How fast a curve may be run through: as fast as each joint and each watched point allows."""

from __future__ import annotations

import math
from typing import List, Sequence

from probe_bridge.config import Config
from probe_bridge.curve import Sample
from probe_bridge.excess import joints_excess, points_excess
from probe_bridge.fields import Vector
from probe_bridge.geometry import distance
from probe_bridge.trajectory import Trajectory

_MARGIN = 0.95
"""Share of each limit that is used: between samples the motion differs a little."""


def timed(
    samples: Sequence[Sample], points: Sequence[Sequence[Vector]], config: Config
) -> Trajectory:
    """The motion along samples of a curve from rest to rest.

    Speeds are limited where they are, then so that they can be reached from both sides (the
    two passes of time-optimal path parameterisation). Half of a joint's acceleration is kept for
    the curve's bends, half for speeding up and slowing down.

    Args:
        samples: Of the curve.
        points: The watched points at each sample, metres.
        config: Whose limits count.
    """
    speeds = _allowed(samples, points, config)
    speeds[0] = speeds[-1] = 0.0
    _reach(samples, speeds, config)
    samples_back = list(reversed(samples))
    speeds.reverse()
    _reach(samples_back, speeds, config)
    speeds.reverse()
    times = [0.0]
    for one, two, before, after in zip(samples, samples[1:], speeds, speeds[1:]):
        times.append(times[-1] + 2 * (two.along - one.along) / (before + after))
    velocities = tuple(
        tuple(slope * speed for slope in sample.slope) for sample, speed in zip(samples, speeds)
    )
    motion = Trajectory(tuple(times), tuple(sample.joints for sample in samples), velocities)
    motion = motion.slowed(max(1.0, joints_excess(motion, config)))
    return motion.slowed(max(1.0, points_excess(motion, points, config) / _MARGIN))


def _allowed(
    samples: Sequence[Sample], points: Sequence[Sequence[Vector]], config: Config
) -> List[float]:
    """The highest speed along the curve at each sample, radians a second."""
    joints = config.chain.joints
    speeds: List[float] = []
    for sample in samples:
        speed = math.inf
        for joint, slope, bend in zip(joints, sample.slope, sample.bend):
            if slope:
                speed = min(speed, _MARGIN * joint.speed / abs(slope))
            if bend:
                speed = min(speed, math.sqrt(0.5 * _MARGIN * joint.acceleration / bend))
        speeds.append(speed)
    for i in range(len(samples) - 1):
        moved = max(distance(a, b) for a, b in zip(points[i], points[i + 1]))
        if moved > 0.0:
            length = samples[i + 1].along - samples[i].along
            most = _MARGIN * config.tool_speed * length / moved
            speeds[i] = min(speeds[i], most)
            speeds[i + 1] = min(speeds[i + 1], most)
    return speeds


def _reach(samples: Sequence[Sample], speeds: List[float], config: Config) -> None:
    """Lower speeds, in place, to what each can be reached with from the one before."""
    for i in range(len(samples) - 1):
        length = abs(samples[i + 1].along - samples[i].along)
        gain = min(
            0.5 * _MARGIN * joint.acceleration / max(abs(a), abs(b), 1e-9)
            for joint, a, b in zip(config.chain.joints, samples[i].slope, samples[i + 1].slope)
        )
        speeds[i + 1] = min(speeds[i + 1], math.sqrt(speeds[i] ** 2 + 2 * gain * length))
