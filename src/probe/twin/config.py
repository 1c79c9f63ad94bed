"""The bridge's file for a set-up's twin: the same fields that a real robot's file has."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from probe.scene.cameras import View
from probe.scene.setup import Setup
from probe.station.arms import PEAK_SPEED
from probe.station.remote import BASKET_VIEW
from probe.twin.chain import joints_of, origin_of, points_of
from probe.types import Camera

_AROUND = 0.35
"""Metres of air around work area and basket in which the hand may move."""

_REACH = 0.95
"""Metres from the base within which all of the arm stays."""

_HIGHEST = 1.3
_TOUCH = -0.005
"""Metres below the table's top at which a finger tip is too low: servos aren't stiff."""

_TRAIL, _DELAY = 0.12, 0.25
_FAST = 2.0

FASTEST = 5.0
"""Most haste: beyond it the tool's speed limit would be one that bridges refuse."""


def twin_config(
    setup: Setup, views: Sequence[View] = ("top", "front"), haste: float = 1.0
) -> dict[str, Any]:
    """What a bridge has to know of a set-up's twin, as its JSON file would say it.

    Args:
        setup: The table.
        views: Its fixed cameras that there are; the basket's is always there.
        haste: How much faster than a real one it may be; all speeds are multiplied.
    """
    arm = setup.mount.arm
    joints, tool = joints_of(arm, haste * PEAK_SPEED[arm])
    cameras = {view: setup.camera(view) for view in views} | {BASKET_VIEW: setup.basket_camera}
    lower, upper = _bounds(setup)
    return {
        "name": f"twin of {setup.name}",
        "model": arm,
        "joints": joints,
        "mount": origin_of(setup.mount.base.matrix),
        "tool": origin_of(tool),
        "points": points_of(setup, tool),
        "home": list(setup.mount.parked),
        "tool_box": {"lower": lower, "upper": upper},
        "arm_box": {"lower": lower, "upper": upper},
        "tool_speed": haste * _FAST,
        "trail": _TRAIL,
        "delay": _DELAY,
        "max_opening": setup.gripper.max_opening,
        "cameras": [_camera(name, camera) for name, camera in cameras.items()],
        "driver": {},
    }


def _bounds(setup: Setup) -> tuple[list[float], list[float]]:
    """Corners of the box around all that the arm has to get to, metres."""
    half, (x, y, _), base = setup.work_area / 2, setup.basket.position, setup.mount.base.position
    low = [min(-half, at) - _AROUND for at in (x, y)]
    high = [max(half, at) + _AROUND for at in (x, y)]
    low = [min(edge, middle - _REACH) for edge, middle in zip(low, base, strict=False)]
    high = [max(edge, middle + _REACH) for edge, middle in zip(high, base, strict=False)]
    return [*low, _TOUCH], [*high, _HIGHEST]


def _camera(name: str, camera: Camera) -> dict[str, Any]:
    return {
        "name": name,
        "width": camera.width_px,
        "height": camera.height_px,
        "fx": camera.focal_px,
        "fy": camera.focal_px,
        "cx": camera.width_px / 2,
        "cy": camera.height_px / 2,
        "position": list(camera.world_from_camera.position),
        "wxyz": list(camera.world_from_camera.wxyz),
    }
