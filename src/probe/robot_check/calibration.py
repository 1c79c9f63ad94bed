"""A camera checked by the known box: its error, what mends it, and how well. Moves nothing."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from probe.robot_check.box import KnownBox
from probe.robot_check.fitting import apart, fitted, offset
from probe.robot_check.gross import judged
from probe.robot_check.seeing import SeenBox, told_pose
from probe.types import Pose

FEWEST = 8
"""Places that the box must be seen at."""

_FOCAL = 0.015
"""By which share a focal length may be off."""

FAR, TURNED = 0.02, np.radians(2.0)
"""Metres by which things may seem to be elsewhere, and how far a camera may be turned."""


@dataclass(frozen=True)
class Calibration:
    """What the box says of a camera.

    Attributes:
        camera: Its name.
        places: At how many it was seen.
        fault: What is wrong, or "".
        text: How it shows.
        remedy: How to mend it.
        told: world_from_camera as the bridge tells it.
        corrected: The same as the box shows it, from all places.
        before: Median error of held-out places with the told pose, metres.
        after: The same with a pose from the other places; None if no pose would mend it.
        agree: Between the poses of both halves of the places: metres, and radians.
        focal: By what the told focal length would have to be multiplied.
    """

    camera: str
    places: int
    fault: str
    text: str
    remedy: str
    told: Pose
    corrected: Pose
    before: float = 0.0
    after: float | None = None
    agree: tuple[float, float] = (0.0, 0.0)
    focal: float = 1.0

    @property
    def error(self) -> tuple[float, float]:
        """How far the camera stands from where its bridge says, metres, and is turned, radians."""
        return apart(self.told, self.corrected)

    @property
    def mendable(self) -> bool:
        """Whether the corrected pose is all that is needed."""
        return self.fault in ("", "camera moved") and self.after is not None


def calibrated(sightings: Sequence[SeenBox], box: KnownBox, base: Pose) -> Calibration:
    """What sightings of at least FEWEST places say of their camera.

    Args:
        sightings: Of one camera.
        box: What was held.
        base: world_from_base of the arm.
    """
    name, told = sightings[0].camera.name, told_pose(sightings[0].camera)
    gross = judged(sightings, box, base)
    if gross.fit is None:
        fault, text, remedy = gross.fault, gross.text, gross.remedy
        return Calibration(name, len(sightings), fault, text, remedy, told, told)
    start, focal = gross.fit.world_from_camera, gross.fit.focal
    whole = fitted(sightings, box, start)
    halves = [slice(0, None, 2), slice(1, None, 2)]
    poses = [fitted(sightings[half], box, start).world_from_camera for half in halves]
    errors = [
        (offset(each, box, told, slip), offset(each, box, pose, slip))
        for half, pose in zip(reversed(halves), poses, strict=True)
        for each, slip in zip(sightings[half], whole.slips[half], strict=True)
    ]
    before, after = (float(np.median(column)) for column in zip(*errors, strict=True))
    fault, text, remedy = _fault(focal, told, whole.world_from_camera, before)
    return Calibration(
        *(name, len(sightings), fault, text, remedy, told, whole.world_from_camera),
        *(before, after, apart(*poses), focal),
    )


def _fault(focal: float, told: Pose, corrected: Pose, before: float) -> tuple[str, str, str]:
    if abs(focal - 1) > _FOCAL:
        text = f"The focal lengths would fit if they were {focal:.3f} times as long."
        return (
            "wrong intrinsics",
            text,
            f"Multiply fx and fy by {focal:.3f}, or calibrate it again.",
        )
    moved, turn = apart(told, corrected)
    text = (
        f"It stands {1000 * moved:.1f} mm from where its bridge says,"
        f" turned by {np.degrees(turn):.2f} degrees."
    )
    if before > FAR or turn > TURNED:
        return "camera moved", text, "Put the corrected pose into the robot's file."
    return "", text, ""
