"""Painted frames: a table with upright boxes, as a camera without perspective would see them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from probe.assets.spec import ObjectSpec
from probe.scene.scene import PlacedObject, Scene
from probe.scene.setup import BASKET_CAMERA_HEIGHT, UR5_TABLE
from probe.station.gripper import Gripper
from probe.station.station import Arm, Hand
from probe.station.ur5 import Ur5
from probe.toolshed.skills import ShoveOutcome
from probe.types import Array, Camera, Frame, Pose


@dataclass(frozen=True)
class Block:
    """A box seen from above: left, top, right, bottom in pixels (inclusive), height in metres."""

    instance: int
    box: tuple[int, int, int, int]
    height: float = 0.05
    colour: tuple[int, int, int] = (150, 30, 30)
    share: float = 1.0

    @property
    def pixels(self) -> tuple[slice, slice]:
        left, top, right, bottom = self.box
        return slice(top, bottom + 1), slice(left, right + 1)


def paint(blocks: Sequence[Block], *, rgb: bool = True, camera: Camera | None = None) -> Frame:
    """A frame of blocks, from the top camera or another; where two overlap the higher one shows."""
    camera = camera or UR5_TABLE.camera()
    size = (camera.height_px, camera.width_px)
    labels = np.zeros(size, np.int32)
    heights = np.zeros(size)
    picture = np.full((*size, 3), 120, np.uint8)
    for block in sorted(blocks, key=lambda b: b.height):
        labels[block.pixels] = block.instance
        heights[block.pixels] = block.height
        picture[block.pixels] = block.colour
    depth = (camera.world_from_camera.position[2] - heights).astype(np.float32)
    shares = {b.instance: b.share for b in blocks if (labels == b.instance).any()}
    return Frame(camera, depth, picture if rgb else None, labels, shares)


class PaintedStation:
    """A Station that can only be looked at; a test moves the blocks by hand.

    Blocks that are removed lie in a row in the basket.
    """

    def __init__(self, blocks: Sequence[Block]) -> None:
        self.arm: Arm = Ur5()
        self.hand: Hand = Gripper()
        self.blocks = list(blocks)
        self.removed: list[Block] = []
        self.drawn = 0

    def observe(self, *, rgb: bool) -> Frame:
        self.drawn += rgb
        return paint(self.blocks, rgb=rgb)

    def look_into_basket(self, *, rgb: bool) -> Frame:
        return paint(_in_a_row(self.removed), rgb=rgb, camera=UR5_TABLE.basket_camera)

    def joints(self) -> Array:
        return self.arm.parked

    def follow(self, path: Array) -> bool:
        raise NotImplementedError

    def grip(self, opening: float) -> float:
        raise NotImplementedError

    def wait(self, seconds: float) -> None:
        raise NotImplementedError

    def snapshot(self) -> Scene:
        """Where the blocks are; their ids are secret."""
        placed = [PlacedObject(b.instance, f"id_{b.instance}", _pose(b)) for b in self.blocks]
        return Scene(12345, "table", tuple(placed))

    def remove(self, mask: Array) -> None:
        """Take away whatever shows most under a mask."""
        labels = paint(self.blocks).labels
        assert labels is not None
        hit = int(np.bincount(labels[mask]).argmax())
        self.removed += [b for b in self.blocks if b.instance == hit]
        self.blocks = [b for b in self.blocks if b.instance != hit]

    def shift(self, mask: Array, du: int, dv: int) -> None:
        """Move whatever shows most under a mask."""
        labels = paint(self.blocks).labels
        assert labels is not None
        hit = int(np.bincount(labels[mask]).argmax())
        moved = (du, dv, du, dv)
        self.blocks = [
            replace(b, box=tuple(c + d for c, d in zip(b.box, moved, strict=True)))
            if b.instance == hit
            else b
            for b in self.blocks
        ]


def _in_a_row(blocks: Sequence[Block]) -> list[Block]:
    """Blocks as the basket's camera sees them, side by side, at their true sizes."""
    pixel = UR5_TABLE.view_size / 1024 * UR5_TABLE.basket_camera.focal_px / BASKET_CAMERA_HEIGHT
    placed: list[Block] = []
    left = 60
    for block in blocks:
        width = round(pixel * (block.box[2] - block.box[0] + 1))
        height = round(pixel * (block.box[3] - block.box[1] + 1))
        placed.append(replace(block, box=(left, 60, left + width - 1, 60 + height - 1)))
        left += width + 10
    return placed


@dataclass(frozen=True)
class Done:
    status: str
    frame: Frame
    moved: float | None = 0.07
    shove: ShoveOutcome | None = None


@dataclass
class Obedient:
    """Skills that take away or shift whatever they are pointed at; `status` is what they say.

    With `unmoved` the arm never moves, and nobody looks again.
    """

    status: str = ""
    unmoved: bool = False
    calls: list[tuple[object, ...]] = field(default_factory=list[tuple[object, ...]])

    def grasp_and_remove(self, station, frame: Frame, mask: Array, drop_at) -> Done:
        self.calls.append(("grasp", int(mask.sum()), drop_at))
        if not self.status:
            station.remove(mask)
        return Done(self.status or "removed", self._after(station, frame))

    def push(self, station, frame: Frame, mask: Array, direction, distance_m, basket) -> Done:
        self.calls.append(("push", direction, distance_m))
        if not self.status:
            station.shift(mask, 60, 0)
        return Done(self.status or "pushed", self._after(station, frame))

    def _after(self, station, frame: Frame) -> Frame:
        return frame if self.unmoved else station.observe(rgb=False)


def spec(name: str, *colours: str, category: str = "", description: str = "") -> ObjectSpec:
    """A catalogue entry whose id must never reach an agent."""
    return ObjectSpec(
        id=f"secret_{name.replace(' ', '_')}_77",
        name=name,
        category=category or name.split()[-1],
        colours=colours or ("red",),
        description=description or f"A {name}.",
        mass=0.1234,
        friction=0.5,
        size=(0.1, 0.1, 0.05),
        hollow=False,
        origin="procedural",
        licence="CC0-1.0",
        source="made here",
    )


def _pose(block: Block) -> Pose:
    left, top, right, bottom = block.box
    return Pose(((left + right) / 2000, (top + bottom) / 2000, block.height / 3))
