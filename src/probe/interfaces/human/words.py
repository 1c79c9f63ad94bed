"""What a person is told besides the tools' own texts: product text. Knows no answer."""

from __future__ import annotations

from probe.errors import OutputFailed, ProbeError
from probe.toolshed.toolshed import MANIPULATIONS, TURNS

RULES = (
    "A camera shows you a table with a pile of objects, and a robot arm stands beside it. Each "
    "question is about these objects. Often the first picture doesn't show the answer: then move "
    "what is in the way, look again, and answer.",
    f"For each question you have {TURNS} calls of tools in all, and {MANIPULATIONS} of them, or as "
    "many as the question says, may be grasps or pushes, failed ones included. You may answer "
    "once; whether it was right isn't told.",
    "You may leave at any time: give the same name again, and the question is as you left it.",
)

_DOING = {
    "perceive_scene": "Looking",
    "find_object": "Searching",
    "grasp_and_remove": "The arm is at work",
    "push": "The arm is at work",
    "answer_question": "Writing it down",
}

EXPLAINING = "Drawing what was right"
"""What is going on once a practice question is over."""


class NotNow(ProbeError):
    """What was asked for doesn't fit what is going on."""


def doing_words(tool: str) -> str:
    """What is going on while a tool works."""
    return _DOING.get(tool, "Working")


def trouble_words(error: Exception) -> str:
    """What a person is told of a failure of ours; the log alone says what it was."""
    if isinstance(error, OutputFailed):
        return (
            "This can't be written down: the disk is full, or the folder closed to us. Tell "
            "whoever runs the server; then go on from here."
        )
    return (
        "Something failed that is not your doing; the server's log says what. "
        "Go on to try it again."
    )


NOT_AS_BEFORE = (
    "Your table couldn't be set as you left it, which is not your doing. What you had done counts "
    "for nothing; go on to start the question again."
)
