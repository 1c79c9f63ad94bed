"""A pick under the eyes of a person: the box, found by the camera, goes into the basket."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from probe.manipulation.grasp import grasp_and_remove
from probe.manipulation.looking import above_table
from probe.robot_check.outcomes import PICK
from probe.scene.setup import Setup
from probe.station.remote import RobotStation

if TYPE_CHECKING:
    from probe_bridge.checks.outcome import Outcome

_LEAST_PX = 60


def pick(station: RobotStation, setup: Setup) -> Outcome:
    """Remove what stands alone in the work area, with the skill that agents use."""
    from probe_bridge.checks.outcome import Measure, failed, passed

    frame = station.observe(rgb=False)
    rows, columns = np.indices(frame.depth.shape)
    uv = np.column_stack([columns.ravel(), rows.ravel()]) + 0.5
    points = frame.camera.lift(uv, frame.depth.ravel())
    inside = (np.abs(points[:, :2]) < setup.work_area / 2).all(axis=1)
    mask = above_table(frame) & inside.reshape(frame.depth.shape)
    if mask.sum() < _LEAST_PX:
        text = "The camera sees nothing on the table's work area."
        return failed(PICK, "box not seen", text, "Stand the box there; look at the camera's pose.")
    result = grasp_and_remove(station, frame, mask, setup)
    measures = Measure("tries", result.tries, ""), Measure("width", 1000 * result.width, "mm")
    if result.status == "removed":
        return passed(PICK, "The box went into the basket.", *measures)
    text = f"The box did not go into the basket: {result.status}."
    remedy = "Look at the checks before this one; watch where the hand goes wrong."
    return failed(PICK, "pick failed", text, remedy, *measures)
