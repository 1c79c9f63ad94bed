"""What the bridge answers, as plain values."""

from __future__ import annotations

import zlib
from dataclasses import asdict
from typing import Any, Dict, cast

from probe_bridge.config import BridgeCamera, Config
from probe_bridge.driver import Shot
from probe_bridge.errors import BridgeError
from probe_bridge.wire import VERSION


def described(config: Config, clock: float) -> Dict[str, Any]:
    """The robot, as the reply to hello; `clock` is the robot's, seconds."""
    joints = [
        {
            "name": joint.name,
            "lower": joint.lower,
            "upper": joint.upper,
            "speed": joint.speed,
            "acceleration": joint.acceleration,
        }
        for joint in config.chain.joints
    ]
    return {
        "version": VERSION,
        "name": config.name,
        "model": config.model,
        "joints": joints,
        "home": list(config.home),
        "max_opening": config.max_opening,
        "cameras": [camera_values(camera) for camera in config.cameras.values()],
        "clock": clock,
    }


def camera_values(camera: BridgeCamera) -> Dict[str, Any]:
    """A camera as plain values; see BridgeCamera."""
    values = asdict(camera)
    values["position"] = list(camera.position)
    values["wxyz"] = list(camera.wxyz)
    return values


def pictured(shot: Shot, camera: BridgeCamera) -> Dict[str, Any]:
    """A picture, compressed, with where it was taken from.

    Raises:
        BridgeError: "fault"; the camera's pictures don't have the size that the config states.
    """
    pixels = camera.width * camera.height
    sizes_fit = len(shot.depth) == 2 * pixels and (shot.rgb is None or len(shot.rgb) == 3 * pixels)
    if (shot.width, shot.height) != (camera.width, camera.height) or not sizes_fit:
        raise BridgeError(
            "fault",
            f"Camera {camera.name} gives {shot.width} x {shot.height} pixels"
            f" ({len(shot.depth)} bytes of depth), not {camera.width} x {camera.height}.",
            "Correct the config, intrinsics included.",
        )
    return {
        # Level 1: the arm's computer is slow, and the network rarely is.
        "rgb": None if shot.rgb is None else zlib.compress(shot.rgb, 1),
        "depth": zlib.compress(shot.depth, 1),
        "depth_unit": shot.depth_unit,
        "width": shot.width,
        "height": shot.height,
        "stamp": shot.stamp,
        "camera": camera_values(camera),
    }


def failed(error: BridgeError) -> Dict[str, str]:
    """An error as plain values."""
    return {"kind": error.kind, "text": error.text[:2000], "remedy": error.remedy[:2000]}


def error_of(values: object) -> BridgeError:
    """The error that `failed` packed; for clients."""
    table = cast("Dict[str, object]", values) if isinstance(values, dict) else {}
    kind, text, remedy = (str(table.get(key, "")) for key in ("kind", "text", "remedy"))
    return BridgeError(kind or "fault", text or "The bridge failed without a reason.", remedy)
