"""Corrected cameras as a file that a robot's bridge reads."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from probe.files import write_text
from probe.robot_check.calibration import Calibration

if TYPE_CHECKING:
    from probe_bridge.config import BridgeCamera


def corrected(
    cameras: Mapping[str, BridgeCamera], found: Sequence[Calibration]
) -> list[BridgeCamera]:
    """All cameras of a robot, those with the poses found that nothing worse is wrong with."""
    poses = {each.camera: each.corrected for each in found if each.mendable}
    return [
        replace(camera, position=poses[name].position, wxyz=poses[name].wxyz)
        if name in poses
        else camera
        for name, camera in cameras.items()
    ]


def write_cameras(path: Path, cameras: Sequence[BridgeCamera]) -> None:
    """Write cameras as the field "cameras" of a robot's file has them.

    Raises:
        OutputFailed: The file can't be written.
    """
    from probe_bridge.replies import camera_values

    write_text(path, json.dumps([camera_values(camera) for camera in cameras], indent=1) + "\n")
