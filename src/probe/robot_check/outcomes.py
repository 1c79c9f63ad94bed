"""What the checks with a known box found, told as the bridge's own checks tell theirs."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from probe.robot_check.calibration import FEWEST, Calibration
from probe.robot_check.errors import Impossible
from probe.robot_check.reach import out_of_reach
from probe.scene.setup import Setup
from probe.station.station import Station

if TYPE_CHECKING:
    from probe_bridge.checks.outcome import Outcome
    from probe_bridge.description import JointLimits

BOX, REACH, PICK = "box", "reach", "pick"

_LEAST = 0.9
"""Share of the work area that must be in reach."""


def camera_outcome(found: Calibration) -> Outcome:
    """What the box says of a camera."""
    from probe_bridge.checks.outcome import Measure, failed, passed

    name = f"camera {found.camera}"
    measures = [Measure("places", found.places, "")]
    if found.after is not None:
        moved, turn = found.error
        measures += [
            Measure("stands off by", 1000 * moved, "mm"),
            Measure("turned by", np.degrees(turn), "degrees"),
            Measure("things seem off by", 1000 * found.before, "mm"),
            Measure("once corrected", 1000 * found.after, "mm"),
            Measure("both halves of the places differ by", 1000 * found.agree[0], "mm"),
            Measure("and", np.degrees(found.agree[1]), "degrees"),
            Measure("focal length off by", 100 * (found.focal - 1), "%"),
        ]
    if found.fault:
        return failed(name, found.fault, found.text, found.remedy, *measures)
    return passed(name, found.text, *measures)


def unseen(camera: str, places: int) -> Outcome:
    """A camera that saw the box too seldom."""
    from probe_bridge.checks.outcome import Measure, failed

    return failed(
        f"camera {camera}",
        "box not seen",
        f"The box was made out at {places} places; {FEWEST} are needed.",
        "Compare the camera's pose in the set-up with where it really stands, and its light.",
        Measure("places", places, ""),
    )


def impossible(check: str, reason: Impossible) -> Outcome:
    """A check that could not go on."""
    from probe_bridge.checks.outcome import failed

    return failed(check, reason.fault, reason.text, reason.remedy)


def reach_outcome(station: Station, setup: Setup, limits: Sequence[JointLimits]) -> Outcome:
    """Whether the arm gets to the work area."""
    from probe_bridge.checks.outcome import Measure, failed, passed

    lower, upper = np.array([(joint.lower, joint.upper) for joint in limits]).T
    missed, tried = out_of_reach(station, setup, lower, upper)
    share = 1 - len(missed) / tried
    measures = Measure("places", tried, ""), Measure("within reach", 100 * share, "%")
    if share < _LEAST:
        x, y, z = missed[0]
        text = f"The hand does not get to {len(missed)} of {tried} places, such as"
        remedy = "Move the base nearer, or make the set-up's work area smaller."
        text = f"{text} ({x:.2f}, {y:.2f}, {z:.2f})."
        return failed(REACH, "out of reach", text, remedy, *measures)
    return passed(REACH, "The hand gets to the work area from above.", *measures)
