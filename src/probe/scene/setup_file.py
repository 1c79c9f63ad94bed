"""A Setup on disk: JSON in which all that isn't said is as in the usual set-up."""

from __future__ import annotations

from dataclasses import asdict
from itertools import product
from pathlib import Path
from typing import Annotated, Literal

import numpy as np
import pydantic

from probe.assets.looks import Looks
from probe.files import read_document
from probe.scene.cameras import CameraPlacement, View
from probe.scene.pose_document import Rotation
from probe.scene.setup import (
    UR5_TABLE,
    ArmMount,
    ArmName,
    Basket,
    GripperSize,
    RendererName,
    Setup,
    as_of_old,
)
from probe.types import Pose

MOST_PX = 4096
"""Edge of the largest pictures, pixels."""

_REMEDY = "See docs/how-to/extend/add-a-setup.md"

_Near = Annotated[float, pydantic.Field(ge=-3, le=3)]
_Place = tuple[_Near, _Near, _Near]
_Length = Annotated[float, pydantic.Field(ge=0.05, le=3)]


class _Document(pydantic.BaseModel, extra="forbid", allow_inf_nan=False):
    pass


class MountDocument(_Document):
    """Which arm it is, where it stands, and its joint angles when it is parked, radians."""

    position: _Place = UR5_TABLE.mount.base.position
    wxyz: Rotation = UR5_TABLE.mount.base.wxyz
    parked: tuple[float, ...] = pydantic.Field(
        default=UR5_TABLE.mount.parked, min_length=6, max_length=6
    )
    # Left out where it is the usual one, as files of before there was another do.
    arm: ArmName = pydantic.Field(
        default=UR5_TABLE.mount.arm, exclude_if=lambda arm: arm == UR5_TABLE.mount.arm
    )

    @pydantic.model_validator(mode="after")
    def _waits_where_it_says(self) -> MountDocument:
        if self.arm != UR5_TABLE.mount.arm and "parked" not in self.model_fields_set:
            raise ValueError(f"parked: say the joint angles at which the {self.arm} waits")
        return self


class GripperDocument(_Document):
    """Sizes of the gripper, metres."""

    max_opening: float = pydantic.Field(default=UR5_TABLE.gripper.max_opening, ge=0.05, le=0.17)
    pad_width: float = pydantic.Field(default=UR5_TABLE.gripper.pad_width, ge=0.01, le=0.05)
    pad_length: float = pydantic.Field(default=UR5_TABLE.gripper.pad_length, ge=0.03, le=0.09)


class TopDocument(_Document):
    """The camera above the table's middle: its height, and the width of table that it sees."""

    height: float = pydantic.Field(default=UR5_TABLE.top.eye[2], ge=0.5, le=3)
    width: float = pydantic.Field(default=UR5_TABLE.top.width, ge=0.3, le=1.2)


class FrontDocument(_Document):
    """The oblique camera: its place, what it looks at, and its field of view."""

    eye: _Place = UR5_TABLE.front.eye
    target: _Place = UR5_TABLE.front.target
    fov_deg: float = pydantic.Field(default=UR5_TABLE.front.fov_deg, ge=10, le=100)

    @pydantic.model_validator(mode="after")
    def _is_oblique(self) -> FrontDocument:
        if self.eye[1] >= self.target[1] or self.eye[2] <= self.target[2]:
            raise ValueError("the front camera looks down along +y: lower its eye's y, or raise it")
        return self


class BasketDocument(_Document):
    """Middle of the basket's floor, and its inner extent along x and y and its height."""

    position: _Place = UR5_TABLE.basket.position
    size: tuple[_Length, _Length, _Length] = UR5_TABLE.basket.size


class SetupDocument(_Document):
    """A whole set-up; metres unless a name says otherwise."""

    version: Literal[1] = 1
    name: str = pydantic.Field(pattern=r"^[a-z0-9][a-z0-9-]{0,39}$")
    mount: MountDocument = MountDocument()
    gripper: GripperDocument = GripperDocument()
    top: TopDocument = TopDocument()
    front: FrontDocument = FrontDocument()
    basket: BasketDocument = BasketDocument()
    work_area: float = pydantic.Field(default=UR5_TABLE.work_area, ge=0.2, le=1)
    table_size: tuple[_Length, _Length] = UR5_TABLE.table_size
    picture_px: int = pydantic.Field(default=UR5_TABLE.picture_px, ge=256, le=MOST_PX)
    depth_noise: float = pydantic.Field(default=UR5_TABLE.depth_noise, ge=0, le=0.003)
    # Left out where they are the usual ones, as files of before there were others do.
    lighting: str = pydantic.Field(
        default=UR5_TABLE.lighting, exclude_if=lambda it: it == UR5_TABLE.lighting
    )
    looks: Looks = pydantic.Field(
        default=UR5_TABLE.looks, exclude_if=lambda it: it == UR5_TABLE.looks
    )
    renderer: RendererName = pydantic.Field(
        default=UR5_TABLE.renderer, exclude_if=lambda it: it == UR5_TABLE.renderer
    )

    @pydantic.model_validator(mode="after")
    def _fits_together(self) -> SetupDocument:
        if self.work_area > self.top.width:
            raise ValueError("work_area: it is wider than what the top camera sees, top.width")
        if self.top.width > min(self.table_size):
            raise ValueError("top.width: the top camera sees beyond the table, table_size")
        if self.name == UR5_TABLE.name and as_of_old(self.setup()) != UR5_TABLE:
            raise ValueError(f"name: {self.name} is the usual set-up's, and this one differs")
        if sees_basket(self.setup(), "top"):
            raise ValueError("basket: the top camera sees it; move one of them")
        return self

    @staticmethod
    def of(setup: Setup) -> SetupDocument:
        """The document of a set-up."""
        mount, top = setup.mount, setup.top
        return SetupDocument(
            name=setup.name,
            mount=MountDocument(
                position=mount.base.position,
                wxyz=mount.base.wxyz,
                parked=mount.parked,
                arm=mount.arm,
            ),
            gripper=GripperDocument(**asdict(setup.gripper)),
            top=TopDocument(height=top.eye[2], width=top.width),
            front=FrontDocument(**asdict(setup.front)),
            basket=BasketDocument(**asdict(setup.basket)),
            work_area=setup.work_area,
            table_size=setup.table_size,
            picture_px=setup.picture_px,
            depth_noise=setup.depth_noise,
            lighting=setup.lighting,
            looks=setup.looks,
            renderer=setup.renderer,
        )

    def setup(self) -> Setup:
        """The set-up it describes."""
        mount, front = self.mount, self.front
        return Setup(
            name=self.name,
            mount=ArmMount(Pose(mount.position, mount.wxyz), mount.parked, mount.arm),
            gripper=GripperSize(**self.gripper.model_dump()),
            top=CameraPlacement.above(self.top.height, self.top.width),
            front=CameraPlacement(front.eye, front.target, front.fov_deg),
            basket=Basket(self.basket.position, self.basket.size),
            work_area=self.work_area,
            table_size=self.table_size,
            picture_px=self.picture_px,
            depth_noise=self.depth_noise,
            lighting=self.lighting,
            looks=self.looks,
            renderer=self.renderer,
        )


def read_setup(path: Path) -> Setup:
    """Read a set-up from a file.

    Raises:
        BadData: The file is missing or a field is invalid; the message names the field.
    """
    return read_document(path, SetupDocument, _REMEDY).setup()


def sees_basket(setup: Setup, view: View) -> bool:
    """Whether what lies in the basket would show in a camera's picture."""
    middle, size = np.array(setup.basket.position), np.array(setup.basket.size)
    steps = np.linspace(-0.5, 0.5, 9)
    inside = np.array([middle + size * (x, y, z + 0.5) for x, y, z in product(steps, repeat=3)])
    pixels = setup.camera(view).project(inside)
    return bool(((pixels >= 0) & (pixels < setup.picture_px)).all(axis=1).any())
