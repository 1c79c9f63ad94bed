"""What became of a grasp or a push, in words for the agent: what the hand felt and the cameras saw.

The hand tells how far it got; where the thing is now, and whether it worked, the cameras tell.
"""

from __future__ import annotations

import math
from typing import NamedTuple

from probe.changes.change import Change
from probe.toolshed.skills import Direction, ShoveOutcome

FELT = {
    "removed": "the gripper held something until it let go over the basket",
    "no_candidate": "no place to grip was found on what shows of {id}. It may be too wide, too "
    "flat or too hidden. Nothing was moved. Push it, or first clear what stands around it",
    "unreachable": "no grip on {id} is within reach without hitting other objects. Nothing was "
    "moved. Push it to a freer place, or first clear what stands around it",
    "blocked": "the gripper touched something and stopped",
    "slipped": "the gripper got no hold of {id}, or lost it while lifting",
    "dropped": "the gripper lost what it held on the way to the basket",
    "moved": "the gripper did not keep hold of {id}",
}
"""What the hand felt during a grasp, by the skill's status."""

SHOVED = (
    "the fingers found no way to {id}, so the closed gripper first pushed it{far} towards the "
    "{side} of the picture"
)
"""What is said of a push that came before a grasp."""

_UNSURE_CM = 0.7
"""By how much outlines of things that also turn were seen to mislead."""

_SIDES: dict[Direction, str] = {"up": "top", "down": "bottom", "left": "left", "right": "right"}

_NO_GRIP_EITHER = "After that there was no grip on it either"

ADVICE = {
    "no_candidate": "Push it further, or first clear what stands around it.",
    "unreachable": "Push it further, or first clear what stands around it.",
    "blocked": "If something stands next to it, clear that or push it aside first. If not, push "
    "it, or grasp it once more.",
    "slipped": "Grasp it once more, or push it.",
    "dropped": "Grasp it once more, or push it.",
    "moved": "Grasp it once more, or push it.",
}
"""What may help with a thing that still shows on the table, by the skill's status."""

SWEPT = {
    "pushed": "the gripper pushed the whole way",
    "short": "the gripper pushed for only part of the way, up to where its reach or the basket "
    "ended it",
    "unmoved": "the gripper went the whole way",
    "no_space": "there is no free spot behind {id} or on it where the gripper could come down for "
    "a push this way. Nothing was moved. Try another direction, or grasp it",
    "unreachable": "the arm can't make this push. Nothing was moved. Try another direction or a "
    "shorter distance, or grasp it",
    "blocked": "the gripper met something too heavy or too firm and stopped early",
}
"""What the hand felt during a push, by the skill's status."""

ENOUGH = 0.5
"""Share of the distance asked for that a thing has to go for a push to have worked."""


class OutcomeText(NamedTuple):
    """Whether it worked, and a sentence or more about it."""

    worked: bool
    words: str


def no_grasp_words(status: str, object_id: str) -> OutcomeText:
    """What is said of a grasp that ended before the arm moved."""
    return OutcomeText(False, f"{FELT[status].format(id=object_id)}.")


def no_push_words(status: str, object_id: str) -> OutcomeText:
    """What is said of a push that ended before the arm moved."""
    return OutcomeText(False, f"{SWEPT[status].format(id=object_id)}.")


def grasp_words(
    status: str, object_id: str, change: Change, now: str, shove: ShoveOutcome | None = None
) -> OutcomeText:
    """What became of a grasp.

    Args:
        status: The skill's.
        object_id: What the thing was called.
        change: What the cameras saw of it.
        now: What it is called from now on.
        shove: The push that came first; None without one.
    """
    if change.fate == "basket":
        how = "was lifted and dropped into" if status == "removed" else "ended up in"
        first = "" if shove is None else f" {_capital(_shoved(shove, object_id))}."
        return OutcomeText(True, f"{object_id} {how} the basket.{first}")
    felt = _felt(status, object_id, shove)
    return OutcomeText(False, f"{felt}. {_whereabouts(status, object_id, change, now)}")


def _felt(status: str, object_id: str, shove: ShoveOutcome | None) -> str:
    """What the hand felt, from the first push to the last grasp."""
    if shove is None:
        return FELT[status].format(id=object_id)
    first = _shoved(shove, object_id)
    if shove.moved is None:
        return first
    if status in ("no_candidate", "unreachable"):
        return f"{first}. {_NO_GRIP_EITHER}"
    return f"{first}. Then {FELT[status].format(id=object_id)}"


def _shoved(shove: ShoveOutcome, object_id: str) -> str:
    far = "" if shove.moved is None else f" about {max(0, round(100 * shove.moved))} cm"
    return SHOVED.format(id=object_id, far=far, side=_SIDES[shove.direction])


def _capital(sentence: str) -> str:
    return sentence[0].upper() + sentence[1:]


def push_words(
    status: str, object_id: str, change: Change, moved: float | None, asked: float, now: str
) -> OutcomeText:
    """What became of a push.

    Args:
        status: The skill's.
        object_id: What the thing was called.
        change: What the cameras saw of it.
        moved: How far it went the way it was pushed, metres; None if the camera can't tell.
        asked: How far it was to go, metres.
        now: What it is called from now on.
    """
    swept = SWEPT[status].format(id=object_id)
    shows = change.fate in ("stayed", "moved", "turned")
    if moved is None or not shows:
        return OutcomeText(False, f"{swept}. {_whereabouts(status, object_id, change, now)}")
    worked = moved >= ENOUGH * asked
    how_far = f"{object_id} {_went(change, moved, worked=worked)}{lying(change)}"
    renamed = "" if now == object_id else f"; it is {now} now"
    advice = "" if worked else " Push it in another direction or further, or grasp it."
    return OutcomeText(worked, f"{swept}; {how_far}{renamed}.{advice}")


def _went(change: Change, moved: float, *, worked: bool) -> str:
    """How far a thing went, if what shows of it tells."""
    place = "" if change.after is None else f" {_place(change)}"
    if change.partly:
        went = "moved that way, to" if worked else "is now at"
        return f"{went}{place} (how far can't be told, since it shows more or less of itself)"
    bound, way = ("at least", at_least(100 * moved)) if change.at_least else ("about", 100 * moved)
    return f"moved {bound} {max(0, round(way))} cm that way" + (place and f", to{place}")


def _whereabouts(status: str, object_id: str, change: Change, now: str) -> str:
    advice = f" {ADVICE[status]}" if status in ADVICE else ""
    renamed = "" if now == object_id else f" It is {now} now."
    if change.fate == "stayed":
        return f"{object_id} is still about where it was.{renamed}{advice}"
    if change.fate == "moved":
        where = f"now at {_place(change)}{lying(change)}"
        return f"{object_id} is still on the table, {where}.{renamed}{advice}"
    if change.fate == "turned":
        how = f"{object_id} is still there, but turned or tipped, at {_place(change)}"
        return f"{how}.{renamed}{advice}"
    if change.fate == "basket":
        return f"{object_id} lies in the basket."
    if change.fate == "beside":
        return f"{object_id} lies beside the basket, at the edge of the picture or outside it."
    return _unfound(object_id, change)


def _unfound(object_id: str, change: Change) -> str:
    if not change.before.thing.nameable:
        return f"{object_id}, of which only a part showed, was not found again{perhaps(change)}."
    if change.perhaps:
        return f"{object_id} was not found again{perhaps(change)}."
    if change.doubtful:
        return (
            f"{object_id} was not found again: it may have left the picture, or be something of "
            "which only a part shows."
        )
    if change.fate == "covered":
        return f"{object_id} shows no longer; something has come over the place where it was."
    return f"{object_id} shows neither on the table nor in the basket."


def lying(change: Change) -> str:
    """What follows the place of a thing that lies otherwise than before."""
    return ", turned or tipped" if change.turned else ""


def at_least(way: float) -> int:
    """Whole centimetres that a thing surely went, of those measured by parts of its outline."""
    return max(1, math.floor(way - _UNSURE_CM)) if way >= 1 else 0


def perhaps(change: Change) -> str:
    """What follows when a thing isn't found: what has come to light that it may be."""
    if change.perhaps is None:
        open_to_all = change.doubtful and not change.before.thing.nameable
        return ", unless it belongs to something that has come to light" if open_to_all else ""
    thing = change.perhaps.thing
    return f", unless it is {bracketed(thing.words.called)} at {list(thing.point_px)}"


def bracketed(called: str) -> str:
    """A description's details in brackets, as other words follow: "... (gray, ...) by 5 cm"."""
    what, colon, details = called.partition(": ")
    return f"{what} ({details})" if colon else called


def _place(change: Change) -> str:
    assert change.after is not None
    return str(list(change.after.thing.point_px))
