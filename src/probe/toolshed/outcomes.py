"""What became of a grasp or a push, in words for the agent. Knows no motion."""

from __future__ import annotations

from typing import NamedTuple

GRASP_WORDS = {
    "removed": "{id} was lifted and dropped into the basket.",
    "no_candidate": "no place to grip was found on what shows of {id}. It may be too wide, too "
    "flat or too hidden. Nothing was moved. Push it, or first clear what stands around it.",
    "unreachable": "no grip on {id} is within reach without hitting other objects. Nothing was "
    "moved. Push it to a freer place, or first clear what stands around it.",
    "blocked": "the gripper touched something on its way to {id} and stopped; objects there may "
    "have moved. First clear or push aside what stands next to it, or push {id} itself.",
    "slipped": "the gripper closed on {id} but lost it while lifting. It is still on the table "
    "and may have moved. Try again with a new object_id, or push it.",
    "dropped": "{id} fell on the way to the basket. It has moved; if it no longer shows in the "
    "picture, it lies outside and is out of reach.",
    "moved": "{id} is no longer where it was, but it did not get into the basket. If it no "
    "longer shows in the picture, it lies outside and is out of reach.",
}

PUSH_WORDS = {
    "pushed": "the gripper pushed the whole way{moved}. What it met has moved as well.",
    "short": "the gripper pushed for only part of the way, up to where its reach or the basket "
    "ended it{moved}. What it met has moved as well.",
    "unmoved": "the gripper went the whole way, but {id} hardly moved. Push it in another "
    "direction or further, or grasp it.",
    "no_space": "there is no free spot behind {id} or on it where the gripper could come down for "
    "a push this way. Nothing was moved. Try another direction, or grasp it.",
    "unreachable": "the arm can't make this push. Nothing was moved. Try another direction or a "
    "shorter distance, or grasp it.",
    "blocked": "the gripper met something too heavy or too firm and stopped early; objects there "
    "may have moved. Try another direction, or first clear what stands in the way.",
}

_WORKED = frozenset(("removed", "pushed", "short"))


class OutcomeText(NamedTuple):
    """Whether it worked, and a sentence or more about it."""

    worked: bool
    words: str


def grasp_words(status: str, object_id: str) -> OutcomeText:
    """What became of a grasp, by the skill's status."""
    return OutcomeText(status in _WORKED, GRASP_WORDS[status].format(id=object_id))


def push_words(status: str, object_id: str, moved: float | None) -> OutcomeText:
    """What became of a push, by the skill's status and how far the thing went, metres."""
    how_far = f"; {object_id} can't be told by its looks any more"
    if moved is not None:
        how_far = f"; {object_id} moved about {max(0, round(100 * moved))} cm that way"
    return OutcomeText(status in _WORKED, PUSH_WORDS[status].format(id=object_id, moved=how_far))
