"""Whether each joint, and it alone, turns the way it is asked to."""

from __future__ import annotations

import time
from typing import List, Optional, Sequence, Tuple

from probe_bridge.checks.outcome import Measure, Outcome, failed, passed, skipped
from probe_bridge.client import RobotClient
from probe_bridge.curve import Row
from probe_bridge.errors import BridgeError

JOINTS = "joints"

_TURN = 0.05
"""Radians that each joint is asked to turn: 2.9 degrees, less than any arm may trail."""

_MOVED = 0.02
_EXACT = 0.01
_RESTING = 0.3

_SWAPPED = "swapped axes"
_CHECK_ORDER = "Put the names of the joints in the driver into the order of the robot's file."


def check_joints(client: RobotClient) -> Outcome:
    """Turn each joint by some degrees and back, and see which joints turned."""
    limits = client.description.joints
    errors: List[float] = []
    refused: List[str] = []
    for number, joint in enumerate(limits):
        turned = _turned(client, number)
        if turned is None:
            refused.append(joint.name)
            continue
        asked, changes = turned
        wrong = _wrong([each.name for each in limits], number, asked, changes)
        if wrong:
            return wrong
        errors.append(abs(changes[number] - asked))
    if not errors:
        return skipped(JOINTS, "The bridge lets no joint turn from here; bring the arm home.")
    measures = (
        Measure("turned", len(errors), "joints"),
        Measure("largest error", max(errors), "rad"),
    )
    if refused:
        names = ", ".join(refused)
        return passed(JOINTS, f"All turn as asked but {names}, which may not turn here.", *measures)
    return passed(JOINTS, "Each joint turns as asked, and no other with it.", *measures)


def _turned(client: RobotClient, number: int) -> Optional[Tuple[float, Sequence[float]]]:
    """What a joint was asked to turn by, and by how much each turned; None where it may not."""
    for turn in (_TURN, -_TURN):
        start = client.joints()
        goal = tuple(a + turn * (k == number) for k, a in enumerate(start))
        try:
            client.follow([start, goal])
        except BridgeError as error:
            if error.kind == "refused":
                continue
            if error.kind not in ("blocked", "outside"):
                raise
        changes = [b - a for a, b in zip(start, client.joints())]
        if max(map(abs, changes)) < _MOVED:  # perhaps the angles come late
            time.sleep(_RESTING)
            changes = [b - a for a, b in zip(start, client.joints())]
        _bring_back(client, start)
        return turn, changes
    return None


def _bring_back(client: RobotClient, start: Row) -> None:
    try:
        client.follow([client.joints(), start])
    except BridgeError as error:
        if error.kind not in ("blocked", "outside", "refused"):
            raise


def _wrong(
    names: Sequence[str], number: int, asked: float, changes: Sequence[float]
) -> Optional[Outcome]:
    """What is wrong with how the joints turned; None if nothing is."""
    name, own = names[number], changes[number]
    others = [abs(change) * (k != number) for k, change in enumerate(changes)]
    most = others.index(max(others))
    measures = (Measure(name, own, "rad"), Measure(names[most], changes[most], "rad"))
    if others[most] > _MOVED and abs(own) < _MOVED:
        text = f"{name} was asked to turn, and {names[most]} turned."
        return failed(JOINTS, _SWAPPED, text, _CHECK_ORDER, *measures)
    if others[most] > _MOVED:
        text = f"{name} was asked to turn, and {names[most]} turned with it."
        return failed(JOINTS, "coupled joints", text, _CHECK_ORDER, *measures)
    if own * asked < 0 and abs(own) > _MOVED:
        text = f"{name} turns the wrong way."
        return failed(JOINTS, "joint inverted", text, "Change its sign in the driver.", *measures)
    if abs(own - asked) > _EXACT:
        text = f"{name} turned by {own:.3f} rad where {asked:.3f} were asked for."
        remedy = "Look what holds it, and whether the driver's units are radians."
        return failed(JOINTS, "wrong turn", text, remedy, *measures)
    return None
