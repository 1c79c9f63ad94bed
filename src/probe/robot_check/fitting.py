"""Where a camera really stands, from a known box at known places. Moves nothing.

A fit of six numbers to thousands of points: each point that the camera sees of the box should lie
on the surface that the arm's joints put there.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

from probe.robot_check.box import KnownBox
from probe.robot_check.seeing import SeenBox
from probe.types import Array, Pose

_SOFT = 0.003
"""Metres beyond which a point's distance counts less: noise, and parts of the hand."""

_ENOUGH = 1e-5
"""Share by which a step must improve the fit for another to follow."""

_STEPS = 40
"""Steps after which a fit that hasn't come to rest is taken as it is; good ones need 10."""

_SLIP = 0.002
"""Metres that the box may well have slipped along the pads. Across them it can't."""


@dataclass(frozen=True)
class Fitted:
    """A camera as the box shows it.

    Attributes:
        world_from_camera: Where it stands.
        focal: By what its told focal length has to be multiplied.
        slips: How far the box had slipped along the pads at each place, metres.
        residual: Median distance of the points from the box, metres.
    """

    world_from_camera: Pose
    focal: float
    slips: tuple[float, ...]
    residual: float


def fitted(
    sightings: Sequence[SeenBox], box: KnownBox, start: Pose, *, focal: bool = False
) -> Fitted:
    """The pose, and perhaps the focal length, for which all points lie best on the box.

    How far the box has slipped along the pads is fitted as well, for each place.

    Args:
        sightings: Of one camera.
        box: What was held.
        start: world_from_camera to begin from, not far off.
        focal: Whether the told focal length may be wrong.
    """
    unknown = _Unknown(len(sightings), focal)

    def wrong(values: Array) -> Array:
        slips = unknown.slips(values) / _SLIP
        return np.concatenate([_distances(unknown, values, sightings, box, start), slips * _SOFT])

    done = least_squares(
        wrong,
        np.zeros(unknown.count),
        loss="soft_l1",
        f_scale=_SOFT,
        ftol=_ENOUGH,
        xtol=_ENOUGH,
        max_nfev=_STEPS,
    )
    far = np.abs(_distances(unknown, done.x, sightings, box, start))
    slips = tuple(unknown.slips(done.x).tolist())
    scale = unknown.scale(done.x)
    return Fitted(unknown.pose(done.x, start), scale, slips, float(np.median(far)))


def offset(sighting: SeenBox, box: KnownBox, pose: Pose, slip: float) -> float:
    """How far from its place by the joints a camera at a pose sees the box, metres.

    Args:
        sighting: Of the box.
        box: What was held.
        pose: world_from_camera.
        slip: How far the box had slipped along the pads, metres; it is no error of the camera.
    """
    points = sighting.world_from_box.inverse().apply(pose.apply(sighting.points))
    points -= np.array([slip, 0.0, 0.0])
    done = least_squares(
        lambda shift: box.distances(points + shift), np.zeros(3), loss="soft_l1", f_scale=_SOFT
    )
    return float(np.linalg.norm(done.x))


def apart(one: Pose, other: Pose) -> tuple[float, float]:
    """Distance in metres and turn in radians between two poses."""
    between = one.inverse() @ other
    angle = Rotation.from_matrix(between.rotation).magnitude()
    return float(np.linalg.norm(np.subtract(one.position, other.position))), float(angle)


@dataclass(frozen=True)
class _Unknown:
    """What the numbers of a fit mean: shift, turn, slips, and perhaps the focal length.

    Attributes:
        places: How many there are.
        focal: Whether the focal length is among them.
    """

    places: int
    focal: bool

    @property
    def count(self) -> int:
        return 6 + self.places + self.focal

    def slips(self, values: Array) -> Array:
        """Metres along x of the box, across the fingers, at each place."""
        return values[6 : 6 + self.places]

    def scale(self, values: Array) -> float:
        """By what the focal length is multiplied."""
        return float(np.exp(values[-1])) if self.focal else 1.0

    def pose(self, values: Array, start: Pose) -> Pose:
        """A camera's pose, turned about the world's origin by a vector, then shifted by another.

        So it turns about what it looks at, and shift and turn hardly depend on each other.
        """
        turn = Rotation.from_rotvec(values[3:6]).as_matrix()
        matrix = np.eye(4)
        matrix[:3, :3] = turn @ start.rotation
        matrix[:3, 3] = turn @ np.asarray(start.position) + values[:3]
        return Pose.from_matrix(matrix)


def _distances(
    unknown: _Unknown, values: Array, sightings: Sequence[SeenBox], box: KnownBox, start: Pose
) -> Array:
    """Distances of all points from the box, metres, shape (n,)."""
    pose, focal = unknown.pose(values, start), unknown.scale(values)
    across = np.array([1 / focal, 1 / focal, 1.0])
    found: list[Array] = []
    for each, slip in zip(sightings, unknown.slips(values), strict=True):
        local = each.world_from_box.inverse().apply(pose.apply(each.points * across))
        found.append(box.distances(local - np.array([slip, 0.0, 0.0])))
    return np.concatenate(found)
