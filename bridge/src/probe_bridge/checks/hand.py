"""Whether the hand opens and closes as far as it is asked to."""

from __future__ import annotations

from typing import List, Tuple

from probe_bridge.checks.outcome import Measure, Outcome, failed, passed
from probe_bridge.client import RobotClient

HAND = "gripper"

_SHARES = (1.0, 0.5, 0.0, 1.0)
"""Openings that are asked for, of the largest."""

_EXACT = 0.1
"""How far an empty hand may be off, of its largest opening."""


def check_hand(client: RobotClient) -> Outcome:
    """Open and close the empty hand, and compare what it reaches."""
    most = client.description.max_opening
    moves: List[Tuple[float, float]] = []
    for share in _SHARES:
        reached = client.grip(share * most)
        measured = float(client.state()["opening"])
        moves.append((share * most, measured if abs(measured - reached) > 0.01 else reached))
    wide, shut = moves[0][1], moves[2][1]
    measures = (
        Measure("open", 1000 * wide, "mm"),
        Measure("half", 1000 * moves[1][1], "mm"),
        Measure("shut", 1000 * shut, "mm"),
        Measure("largest", 1000 * most, "mm"),
    )
    if wide < shut - _EXACT * most:
        text = "The hand closes when it is asked to open, and opens when it is asked to close."
        remedy = "Turn the driver's direction round: 0 is shut."
        return failed(HAND, "gripper inverted", text, remedy, *measures)
    if abs(wide - shut) < _EXACT * most:
        text = "The hand does not move."
        return failed(HAND, "gripper still", text, "Activate it; look at its cable.", *measures)
    worst = max(abs(asked - reached) for asked, reached in moves)
    if worst > _EXACT * most:
        text = f"The hand is off by up to {1000 * worst:.0f} mm; it has to be empty for this check."
        remedy = "Correct max_opening in the robot's file, or the driver's unit, which is metres."
        return failed(HAND, "wrong gripper width", text, remedy, *measures)
    return passed(HAND, f"The hand is never off by more than {1000 * worst:.1f} mm.", *measures)
