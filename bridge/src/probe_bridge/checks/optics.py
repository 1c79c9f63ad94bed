"""Whether a camera's intrinsics can be right at all. That they are right needs a known thing."""

from __future__ import annotations

import math
from typing import Optional

from probe_bridge.checks.outcome import Measure, Outcome, failed
from probe_bridge.config import BridgeCamera

_NARROWEST, _WIDEST = 10.0, 130.0
"""Fields of view of depth cameras, degrees, with room to spare."""

_SQUARE = 0.1
_CENTRED = 0.2
"""By which share fx and fy may differ, and the principal point be off the picture's middle."""


def wrong_optics(check: str, camera: BridgeCamera) -> Optional[Outcome]:
    """What can't be right about a camera's figures; None if all may be."""
    if camera.fx <= 0 or camera.fy <= 0:
        return _wrong(check, "a focal length isn't positive")
    field = 2 * math.degrees(math.atan(camera.width / 2 / camera.fx))
    seen = Measure("field of view", field, "degrees")
    if not _NARROWEST <= field <= _WIDEST:
        return _wrong(check, f"it would see {field:.0f} degrees", seen)
    if abs(camera.fx / camera.fy - 1) > _SQUARE:
        return _wrong(check, f"fx {camera.fx:.0f} and fy {camera.fy:.0f} differ too much", seen)
    off = max(abs(camera.cx / camera.width - 0.5), abs(camera.cy / camera.height - 0.5))
    if off > _CENTRED:
        return _wrong(check, "its principal point is far from the picture's middle", seen)
    return None


def _wrong(check: str, problem: str, *measures: Measure) -> Outcome:
    text = f"The camera's intrinsics can't be right: {problem}."
    remedy = "Take fx, fy, cx, cy from the camera's own calibration, for this very picture size."
    return failed(check, "wrong intrinsics", text, remedy, *measures)
