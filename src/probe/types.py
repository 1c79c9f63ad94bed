"""Values every folder shares: poses, cameras, frames. Numpy only; no engine, no files.

Frames of reference: the world is z up with the table's top at z = 0; a camera looks along its
+z with x to the right and y down in the picture (the OpenCV convention). Transforms are named
in the order in which they multiply: ``world_from_camera @ camera_from_object``.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

Array = NDArray[Any]
Ask = Callable[[Sequence[Array], str], str]
"""A vision-language model: pictures (uint8, each (h, w, 3)) and words in, words out. It raises
ModelFailed if no reply comes."""

_T = TypeVar("_T")

Vector3 = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]


@dataclass(frozen=True)
class Pose:
    """A rigid transform: position in metres, rotation as a unit quaternion wxyz."""

    position: Vector3 = (0.0, 0.0, 0.0)
    wxyz: Quaternion = (1.0, 0.0, 0.0, 0.0)

    @property
    def rotation(self) -> Array:
        """Rotation matrix, shape (3, 3)."""
        w, x, y, z = self.wxyz
        return np.array(
            [
                [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
            ]
        )

    @property
    def matrix(self) -> Array:
        """Homogeneous matrix, shape (4, 4)."""
        matrix = np.eye(4)
        matrix[:3, :3] = self.rotation
        matrix[:3, 3] = self.position
        return matrix

    @staticmethod
    def of(position: Array, wxyz: Array) -> Pose:
        """Pose from arrays of shape (3,) and (4,); the quaternion is normalised."""
        x, y, z = (float(v) for v in position)
        a, b, c, d = (float(v) for v in np.asarray(wxyz) / np.linalg.norm(wxyz))
        return Pose((x, y, z), (a, b, c, d))

    @staticmethod
    def from_matrix(matrix: Array) -> Pose:
        """Pose from a homogeneous matrix, shape (4, 4), with an orthonormal rotation."""
        return Pose.of(matrix[:3, 3], quaternion_of(matrix[:3, :3]))

    def apply(self, points: Array) -> Array:
        """Transform points, shape (n, 3)."""
        return points @ self.rotation.T + np.asarray(self.position)

    def __matmul__(self, other: Pose) -> Pose:
        return Pose.from_matrix(self.matrix @ other.matrix)

    def inverse(self) -> Pose:
        """The transform that undoes this one."""
        rotation = self.rotation.T
        position = -rotation @ np.asarray(self.position)
        return Pose.of(position, quaternion_of(rotation))


def quaternion_of(rotation: Array) -> Array:
    """Unit quaternion wxyz with w >= 0 of a rotation matrix, shape (3, 3).

    Bar-Itzhack's method: the eigenvector of the largest eigenvalue of a symmetric 4 x 4 matrix
    (J. Guidance 23(6), 2000); exact for rotations, best fit otherwise.
    """
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = rotation
    k = np.array(
        [
            [xx + yy + zz, zy - yz, xz - zx, yx - xy],
            [zy - yz, xx - yy - zz, xy + yx, xz + zx],
            [xz - zx, xy + yx, yy - xx - zz, yz + zy],
            [yx - xy, xz + zx, yz + zy, zz - xx - yy],
        ]
    )
    wxyz = np.linalg.eigh(k)[1][:, -1]
    return -wxyz if wxyz[0] < 0 else wxyz


def looking_at(eye: Array, target: Array) -> Pose:
    """world_from_camera of a camera at a point that looks at another, the world's z upwards.

    Raises:
        ValueError: It would look straight up or down, where "upwards" means nothing.
    """
    forward = (target - eye) / np.linalg.norm(target - eye)
    right = np.cross(forward, (0.0, 0.0, 1.0))
    length = np.linalg.norm(right)
    if length < 1e-6:
        raise ValueError("The camera looks along the vertical; move the eye a little aside.")
    right = right / length
    rotation = np.column_stack([right, np.cross(forward, right), forward])
    return Pose.of(eye, quaternion_of(rotation))


_STEEP = -math.cos(math.radians(5.0))


@dataclass(frozen=True)
class Camera:
    """A pinhole camera with square pixels and the principal point in the middle.

    Attributes:
        world_from_camera: Pose of the camera (x right, y down, z forward).
        width_px, height_px: Size of the picture.
        fov_y_deg: Full vertical field of view.
    """

    world_from_camera: Pose
    width_px: int
    height_px: int
    fov_y_deg: float

    @property
    def focal_px(self) -> float:
        """Focal length in pixels."""
        return self.height_px / 2 / math.tan(math.radians(self.fov_y_deg) / 2)

    @property
    def looks_down(self) -> bool:
        """Whether it looks straight down, or but for a few degrees: depth then tells height."""
        return float(self.world_from_camera.rotation[2, 2]) < _STEEP

    def rays(self, uv: Array) -> Array:
        """Directions through pixel coordinates (u, v), shape (n, 2), scaled to z = 1, camera frame.

        Pixel centres lie at half-integers: the middle of the top left pixel is (0.5, 0.5).
        """
        centre = np.array([self.width_px, self.height_px]) / 2
        xy = (np.asarray(uv, dtype=float) - centre) / self.focal_px
        return np.column_stack([xy, np.ones(len(xy))])

    def project(self, points: Array) -> Array:
        """Pixel coordinates (u, v) of world points, shape (n, 3); NaN behind the camera."""
        local = self.world_from_camera.inverse().apply(points)
        depth = np.where(local[:, 2:] > 0, local[:, 2:], np.nan)
        centre = np.array([self.width_px, self.height_px]) / 2
        return local[:, :2] / depth * self.focal_px + centre

    def lift(self, uv: Array, depth: Array) -> Array:
        """World points, shape (n, 3), of pixels (u, v) with planar depth in metres, shape (n,)."""
        return self.world_from_camera.apply(self.rays(uv) * np.asarray(depth)[:, None])


@dataclass(frozen=True)
class Frame:
    """What a camera saw at one moment.

    Attributes:
        camera: Where it was taken from.
        depth: Planar metric depth (metres along the camera's z), float32, shape (h, w).
        rgb: Colour, uint8, shape (h, w, 3); None where nobody asked for it.
        labels: Only on simulated frames: instance number of each pixel, int32, shape (h, w);
            0 is the table and all else that is no object.
        shares: Only on simulated frames: by instance, the visible share of each object of which
            at least one pixel shows, 0 to 1.
        depth_noise: Standard deviation of the depth at a pixel, metres; 0 where it is exact.
        measured: Where the camera had a reading, bool, shape (h, w); elsewhere the depth is that
            of the nearest pixel that has one. None if it had one everywhere.
        taken: Only on simulated frames: simulated seconds from the table's beginning.
        painter: Only on simulated frames without colours: paints them as they were at that moment.
    """

    camera: Camera
    depth: Array
    rgb: Array | None = None
    labels: Array | None = None
    shares: Mapping[int, float] | None = None
    depth_noise: float = 0.0
    measured: Array | None = None
    taken: float | None = None
    painter: Callable[[], Array] | None = None


@dataclass(frozen=True)
class Shard:
    """Part of some work: of every `count` pieces the one with this number, from 0."""

    number: int = 0
    count: int = 1

    def of(self, pieces: Sequence[_T]) -> list[_T]:
        """The pieces that belong to it; all shards together are all of them, each once."""
        return list(pieces[self.number :: self.count])


@dataclass(frozen=True)
class PictureScale:
    """What agents have to know to read lengths off a picture.

    Attributes:
        side_px: Edge of the picture, pixels.
        width: How much table it shows across its middle, metres.
        oblique: Whether it is seen from the front rather than from straight above.
        opening: How far the gripper opens, metres.
    """

    side_px: int
    width: float
    oblique: bool
    opening: float


USUAL_SCALE = PictureScale(1024, 0.58, oblique=False, opening=0.12853334344642042)
"""Of the top camera of the usual set-up."""
