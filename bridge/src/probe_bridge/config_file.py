"""Reads the file that describes a robot, and says which field of it is wrong."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any, Dict, List, Tuple, cast

from probe_bridge.config import Box, BridgeCamera, Config
from probe_bridge.errors import BridgeError
from probe_bridge.fields import Fields, Vector
from probe_bridge.geometry import Transform, from_rpy
from probe_bridge.kinematics import Chain, Joint


def load_config(path: Path) -> Config:
    """Read a robot's file. Its cameras may be in a file of their own, which it names.

    Raises:
        BridgeError: "refused"; it can't be read, or a field of it is wrong.
    """
    raw = _read(path)
    if isinstance(raw, dict):
        table = cast("Dict[str, object]", raw)
        cameras = table.get("cameras")
        if isinstance(cameras, str):
            table["cameras"] = _read(path.parent / cameras)
    return read_config(cast(object, raw))


def _read(path: Path) -> object:
    try:
        return cast(object, json.loads(path.read_text(encoding="utf-8")))
    except (OSError, ValueError) as error:
        raise BridgeError("refused", f"{path} can't be read: {error}.") from error


def read_config(raw: object) -> Config:
    """A Config from what a JSON file holds.

    Raises:
        BridgeError: "refused"; it names the field that is wrong.
    """
    fields = Fields(raw, "config")
    joints = tuple(_joint(item) for item in fields.each("joints"))
    if not 1 <= len(joints) <= 16:
        raise fields.wrong("joints", f"has {len(joints)} joints; 1 to 16 are possible")
    chain = Chain(
        _origin(fields.inner("mount")),
        joints,
        _origin(fields.inner("tool")),
        tuple(_point(item, len(joints)) for item in fields.each("points")),
    )
    cameras = [read_camera(item) for item in fields.each("cameras")]
    config = Config(
        name=fields.text("name"),
        model=fields.text("model"),
        chain=chain,
        home=fields.numbers("home", len(joints)),
        tool_box=_box(fields.inner("tool_box")),
        arm_box=_box(fields.inner("arm_box")),
        tool_speed=fields.number("tool_speed", 1e-3, 10.0),
        trail=fields.number("trail", 1e-3, 1.0),
        delay=fields.number("delay", 0.0, 1.0),
        max_opening=fields.number("max_opening", 1e-3, 1.0),
        cameras={camera.name: camera for camera in cameras},
        options=cast("Dict[str, Any]", fields.take("driver")),
    )
    fields.end()
    _cross_check(config, fields, cameras)
    return config


def _cross_check(config: Config, fields: Fields, cameras: List[BridgeCamera]) -> None:
    if len(config.cameras) != len(cameras):
        raise fields.wrong("cameras", "has two of the same name")
    for angle, joint in zip(config.home, config.chain.joints):
        if not joint.lower <= angle <= joint.upper:
            raise fields.wrong("home", f"is outside the limits of {joint.name}")
    boxes = [config.tool_box] + [config.arm_box] * len(config.chain.points)
    for number, point in enumerate(config.chain.watched(config.home)):
        if boxes[number].outside(point) > 0:
            at = ", ".join(f"{v:.3f}" for v in point)
            name = "the tool" if number == 0 else f"points[{number - 1}]"
            raise fields.wrong("home", f"puts {name} at ({at}), outside its box")


def _joint(fields: Fields) -> Joint:
    axis = fields.vector("axis")
    length = math.sqrt(sum(v * v for v in axis))
    if abs(length - 1.0) > 1e-3:
        raise fields.wrong("axis", "is not a unit vector")
    joint = Joint(
        name=fields.text("name"),
        origin=from_rpy(fields.vector("xyz"), fields.vector("rpy")),
        axis=(axis[0] / length, axis[1] / length, axis[2] / length),
        lower=fields.number("lower", -100.0, 100.0),
        upper=fields.number("upper", -100.0, 100.0),
        speed=fields.number("speed", 1e-3, 100.0),
        acceleration=fields.number("acceleration", 1e-3, 1e4),
    )
    if joint.lower >= joint.upper:
        raise fields.wrong("lower", "is not below upper")
    fields.end()
    return joint


def _origin(fields: Fields) -> Transform:
    origin = from_rpy(fields.vector("xyz"), fields.vector("rpy"))
    fields.end()
    return origin


def _point(fields: Fields, joints: int) -> Tuple[int, Vector]:
    point = (fields.whole("after", 0, joints), fields.vector("xyz"))
    fields.end()
    return point


def _box(fields: Fields) -> Box:
    box = Box(fields.vector("lower"), fields.vector("upper"))
    if any(low >= high for low, high in zip(box.lower, box.upper)):
        raise fields.wrong("lower", "is not below upper")
    fields.end()
    return box


def read_camera(fields: Fields) -> BridgeCamera:
    """A camera from its fields; "refused" if one of them is wrong."""
    w, x, y, z = fields.numbers("wxyz", 4)
    if abs(w * w + x * x + y * y + z * z - 1.0) > 1e-3:
        raise fields.wrong("wxyz", "is not a unit quaternion")
    camera = BridgeCamera(
        name=fields.text("name"),
        width=fields.whole("width", 16, 4096),
        height=fields.whole("height", 16, 4096),
        fx=fields.number("fx", 1.0),
        fy=fields.number("fy", 1.0),
        cx=fields.number("cx"),
        cy=fields.number("cy"),
        position=fields.vector("position"),
        wxyz=(w, x, y, z),
    )
    fields.end()
    return camera
