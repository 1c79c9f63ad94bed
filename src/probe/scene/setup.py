"""A table's set-up as one value: arm, gripper, cameras, basket and areas. Data only.

Metres and radians, world frame. The origin is the middle of the table's top, x points away from
the robot, y to its left. In the top camera's picture the right is +x and the top is +y.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Literal

from probe.assets.looks import NEWEST_LOOKS, Looks
from probe.scene.cameras import CameraPlacement, View
from probe.scene.lighting import AMBIENT, ROOM
from probe.types import Camera, PictureScale, Pose, Vector3

BASKET_CAMERA_HEIGHT = 1.2
"""How far above the basket's floor its camera stands, metres: out of the arm's reach."""

BASKET_CAMERA_MARGIN = 0.05
"""How much its camera sees on each side of the basket, metres."""

BASKET_PICTURE_PX = 512
"""Edge of the pictures of the basket."""

FLOOR_DEPTH = 0.75
"""How far below the table's top the floor lies."""


RendererName = Literal["filament", "blender"]
"""What draws colour pictures; depth and labels are Filament's either way."""

ArmName = Literal["ur5", "jaco"]
"""The arms: Universal Robots' UR5, and Kinova's Jaco j2s6s300."""


@dataclass(frozen=True)
class ArmMount:
    """Which arm it is, and where it stands and waits.

    Attributes:
        base: world_from_base. By default the arm points along +x at shoulder pan 0; on its
            pedestal it grasps every point within 0.3 m of the middle and up to 0.3 m high from
            above, and standing on the table it would miss an eighth of them.
        parked: Joint angles at which it is out of every camera's view, radians. By default they
            keep the robot behind x = -0.42 m, hand down.
        arm: Which one.
    """

    base: Pose = Pose((-0.5, 0.0, 0.2), (0.0, 0.0, 0.0, 1.0))
    parked: tuple[float, ...] = (
        math.pi / 2,
        -1.9,
        2.2,
        -0.3 - math.pi / 2,
        -math.pi / 2,
        0.0,
    )
    arm: ArmName = "ur5"


@dataclass(frozen=True)
class GripperSize:
    """Sizes of a gripper built like the 2F-140: two parallel pads, each led by a parallelogram.

    Attributes:
        max_opening: Distance between the open pads; by default that of cranks of 0.1 m.
        pad_width: Of each pad.
        pad_length: Of each pad, along the fingers.
    """

    max_opening: float = 0.12853334344642042
    pad_width: float = 0.027
    pad_length: float = 0.065


@dataclass(frozen=True)
class Basket:
    """Where removed objects go.

    Attributes:
        position: Middle of its floor.
        size: Inner extent along x and y, and the height of its walls.
    """

    position: Vector3 = (-0.55, -0.44, 0.0)
    size: Vector3 = (0.36, 0.36, 0.16)

    def holds(self, x: float, y: float) -> bool:
        """Whether a place lies between its walls."""
        beside = (abs(x - self.position[0]), abs(y - self.position[1]))
        return beside[0] <= self.size[0] / 2 and beside[1] <= self.size[1] / 2


@dataclass(frozen=True)
class Setup:
    """All that is fixed about a table before anything lies on it.

    Attributes:
        name: What people call it.
        mount: The arm and its place.
        gripper: The hand's sizes.
        top: The camera that looks straight down. Whatever settles has to lie in its view.
        front: The oblique camera, before the edge that the top camera's picture shows below.
        basket: Beside the table's middle, out of the top camera's picture. Tasks that the front
            camera shows need it out of that one's, too.
        work_area: Edge of the square around the origin in which objects are dropped.
        table_size: Extent of the table's top along x and y.
        picture_px: Edge of the pictures in pixels.
        depth_noise: Standard deviation of the depth that cameras measure, at each pixel of one
            picture; a look fuses several.
        lighting: Name of the light that its pictures are taken in, unless a run says otherwise.
        looks: How its table and things look.
        renderer: What draws its pictures, unless a run says otherwise.
    """

    name: str = "ur5"
    mount: ArmMount = ArmMount()
    gripper: GripperSize = GripperSize()
    top: CameraPlacement = CameraPlacement.above(1.20, 0.58)
    front: CameraPlacement = CameraPlacement((0.0, -0.92, 0.50), (0.0, 0.0, 0.11), 40.0)
    basket: Basket = Basket()
    work_area: float = 0.50
    table_size: tuple[float, float] = (1.6, 1.4)
    picture_px: int = 1024
    depth_noise: float = 0.0
    lighting: str = AMBIENT.name
    looks: Looks = 1
    renderer: RendererName = "filament"

    @property
    def view_size(self) -> float:
        """Edge of the square of table that the top camera sees."""
        return self.top.width

    def placement(self, view: View) -> CameraPlacement:
        """Where a fixed camera stands, by name."""
        return self.top if view == "top" else self.front

    def camera(self, view: View = "top") -> Camera:
        """A fixed camera, by name."""
        return self.placement(view).camera(self.picture_px)

    @property
    def basket_camera(self) -> Camera:
        """The camera that looks straight down into the basket."""
        x, y, floor = self.basket.position
        width = max(self.basket.size[:2]) + 2 * BASKET_CAMERA_MARGIN
        fov = 2 * math.degrees(math.atan(width / 2 / BASKET_CAMERA_HEIGHT))
        placed = CameraPlacement((x, y, floor + BASKET_CAMERA_HEIGHT), (x, y, floor), fov)
        return placed.camera(BASKET_PICTURE_PX)


UR5_TABLE = Setup()
"""The set-up of the packaged suites."""


def newest(
    setup: Setup,
    lighting: str | None = None,
    looks: Looks = NEWEST_LOOKS,
    renderer: RendererName = "filament",
) -> Setup:
    """A set-up as new scenes have it: with today's looks, in a light that casts shadows.

    Args:
        setup: Any.
        lighting: Name of a light; by default the set-up's own, and the room's where that is even.
        looks: How table and things look.
        renderer: What draws them.
    """
    own = ROOM if setup.lighting == AMBIENT.name else setup.lighting
    return replace(setup, lighting=lighting or own, looks=looks, renderer=renderer)


def as_of_old(setup: Setup) -> Setup:
    """A set-up whose pictures are taken like those of the packaged suites."""
    return replace(setup, lighting=AMBIENT.name, looks=1, renderer="filament")


ROOM_TABLE = newest(UR5_TABLE)
"""The set-up of new scenes."""


def picture_scale(setup: Setup, camera: Camera) -> PictureScale:
    """The scale of a camera's pictures, by its set-up; one that strayed a little doesn't count."""
    oblique = not camera.looks_down
    placed = setup.front if oblique else setup.top
    return PictureScale(camera.width_px, placed.width, oblique, setup.gripper.max_opening)
