"""The one error of the bridge, the same on both ends of the wire."""

from __future__ import annotations


class BridgeError(Exception):
    """Something was refused or went wrong.

    Attributes:
        kind: One of KINDS.
        text: What happened, with the field or the joint that it is about.
        remedy: What to do about it; may be empty.
    """

    def __init__(self, kind: str, text: str, remedy: str = "") -> None:
        super().__init__(f"{text} {remedy}".strip())
        self.kind = kind
        self.text = text
        self.remedy = remedy


KINDS = {
    "refused": "A request breaks a rule or a limit. Nothing moved.",
    "busy": "The robot is doing something else. Nothing moved.",
    "blocked": "The arm fell behind its plan and was stopped.",
    "outside": "The arm left its box and was stopped.",
    "late": "A request was on its way for too long. Nothing moved.",
    "lease": "No lease came in time; the robot was stopped.",
    "stopped": "Somebody asked the robot to stop, or the bridge is closing.",
    "fault": "The driver failed, or what it measures is too old. The robot was stopped.",
    "version": "The two ends speak different versions of the protocol.",
    "unauthorized": "The token is missing or wrong.",
    "taken": "Another client is connected.",
    "lost": "The connection broke, or no answer came in time.",
}
