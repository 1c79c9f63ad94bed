"""What the bridge answers, as plain values."""

from __future__ import annotations

import zlib
from dataclasses import asdict
from typing import Any, Dict, List, cast

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
    _check_size(shot, camera)
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


def glimpsed(shot: Shot, camera: BridgeCamera, step: int) -> Dict[str, Any]:
    """A few pixels of a picture's colours, compressed.

    Raises:
        BridgeError: "fault"; as of pictured, or the camera gives no colours.
    """
    _check_size(shot, camera)
    if shot.rgb is None:
        raise BridgeError("fault", f"Camera {camera.name} gives no colours.")
    few = thinned(shot.rgb, shot.width, shot.height, step)
    return {"rgb": zlib.compress(few, 1), "stamp": shot.stamp}


def thinned(rgb: bytes, width: int, height: int, step: int) -> bytes:
    """Every `step`-th pixel of every `step`-th row, beginning with the first of each."""
    if step == 1:
        return rgb
    rows: List[bytes] = []
    for row in range(0, height, step):
        line = rgb[3 * width * row : 3 * width * (row + 1)]
        few = bytearray(3 * len(range(0, width, step)))
        for channel in range(3):
            few[channel::3] = line[channel :: 3 * step]
        rows.append(bytes(few))
    return b"".join(rows)


def _check_size(shot: Shot, camera: BridgeCamera) -> None:
    pixels = camera.width * camera.height
    sizes_fit = len(shot.depth) == 2 * pixels and (shot.rgb is None or len(shot.rgb) == 3 * pixels)
    if (shot.width, shot.height) != (camera.width, camera.height) or not sizes_fit:
        raise BridgeError(
            "fault",
            f"Camera {camera.name} gives {shot.width} x {shot.height} pixels"
            f" ({len(shot.depth)} bytes of depth), not {camera.width} x {camera.height}.",
            "Correct the config, intrinsics included.",
        )


def failed(error: BridgeError) -> Dict[str, str]:
    """An error as plain values."""
    return {"kind": error.kind, "text": error.text[:2000], "remedy": error.remedy[:2000]}


def error_of(values: object) -> BridgeError:
    """The error that `failed` packed; for clients."""
    table = cast("Dict[str, object]", values) if isinstance(values, dict) else {}
    kind, text, remedy = (str(table.get(key, "")) for key in ("kind", "text", "remedy"))
    return BridgeError(kind or "fault", text or "The bridge failed without a reason.", remedy)
