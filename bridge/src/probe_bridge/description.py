"""What a client learns of a robot: its description and its pictures."""

from __future__ import annotations

import zlib
from dataclasses import dataclass, replace
from typing import Any, Dict, Optional, Tuple

from probe_bridge.config import BridgeCamera
from probe_bridge.config_file import read_camera
from probe_bridge.errors import BridgeError
from probe_bridge.fields import Fields


@dataclass(frozen=True)
class JointLimits:
    """A joint's name and limits: radians, radians a second, radians a second squared."""

    name: str
    lower: float
    upper: float
    speed: float
    acceleration: float


@dataclass(frozen=True)
class Description:
    """What a bridge says of its robot; units as in the config file."""

    name: str
    model: str
    joints: Tuple[JointLimits, ...]
    home: Tuple[float, ...]
    max_opening: float
    cameras: Dict[str, BridgeCamera]
    clock: float


@dataclass(frozen=True)
class Picture:
    """What a camera saw.

    Attributes:
        camera: Where it was taken from.
        depth: Planar depth, uint16, little-endian, row by row, in steps of `depth_unit` metres.
        rgb: Three bytes a pixel, or None.
        stamp: When, by the robot's clock, seconds.
    """

    camera: BridgeCamera
    depth: bytes
    depth_unit: float
    rgb: Optional[bytes]
    stamp: float


@dataclass(frozen=True)
class GlimpsePicture:
    """A small colour picture for a film.

    Attributes:
        camera: Where it was taken from; its pixels are those of the small picture.
        rgb: Three bytes a pixel.
        stamp: When, by the robot's clock, seconds.
        joints: Measured when it had come from the camera, radians.
        took: Seconds that the robot's side took for it.
    """

    camera: BridgeCamera
    rgb: bytes
    stamp: float
    joints: Tuple[float, ...]
    took: float


def read_description(values: Dict[str, Any]) -> Description:
    """From the reply to hello."""
    fields = Fields(values, "hello's reply")
    joints = tuple(
        JointLimits(
            name=joint.text("name"),
            lower=joint.number("lower"),
            upper=joint.number("upper"),
            speed=joint.number("speed"),
            acceleration=joint.number("acceleration"),
        )
        for joint in fields.each("joints")
    )
    cameras = [read_camera(camera) for camera in fields.each("cameras")]
    return Description(
        name=fields.text("name"),
        model=fields.text("model"),
        joints=joints,
        home=fields.numbers("home", len(joints)),
        max_opening=fields.number("max_opening"),
        cameras={camera.name: camera for camera in cameras},
        clock=fields.number("clock", 0.0, 1e12),
    )


def read_picture(values: Dict[str, Any]) -> Picture:
    """From the reply to observe."""
    fields = Fields(values, "reply")
    colour = fields.take("rgb")
    seen = read_camera(fields.inner("camera"))
    pixels = seen.width * seen.height
    return Picture(
        camera=seen,
        depth=_unpacked(fields.take("depth"), 2 * pixels),
        depth_unit=fields.number("depth_unit"),
        rgb=None if colour is None else _unpacked(colour, 3 * pixels),
        stamp=fields.number("stamp", 0.0, 1e12),
    )


def read_glimpse(
    values: Dict[str, Any], camera: BridgeCamera, step: int, joints: int
) -> GlimpsePicture:
    """From the reply to glimpse, for an arm of so many joints."""
    fields, small = Fields(values, "reply"), coarser(camera, step)
    return GlimpsePicture(
        camera=small,
        rgb=_unpacked(fields.take("rgb"), 3 * small.width * small.height),
        stamp=fields.number("stamp", 0.0, 1e12),
        joints=fields.numbers("joints", joints),
        took=fields.number("took", 0.0),
    )


def coarser(camera: BridgeCamera, step: int) -> BridgeCamera:
    """A camera whose pixels are every `step`-th of another's, beginning with the first."""
    return replace(
        camera,
        width=len(range(0, camera.width, step)),
        height=len(range(0, camera.height, step)),
        fx=camera.fx / step,
        fy=camera.fy / step,
        cx=(camera.cx - 0.5) / step + 0.5,
        cy=(camera.cy - 0.5) / step + 0.5,
    )


def _unpacked(data: object, size: int) -> bytes:
    """Decompressed bytes of a known size; never more, however well it was packed."""
    if not isinstance(data, bytes):
        raise BridgeError("lost", "A picture is not bytes.")
    try:
        unpacked = zlib.decompressobj().decompress(data, size + 1)
    except zlib.error as error:
        raise BridgeError("lost", f"A picture can't be unpacked: {error}.") from error
    if len(unpacked) != size:
        raise BridgeError("lost", f"A picture has not the {size} bytes of its size.")
    return unpacked
