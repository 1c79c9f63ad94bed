"""The teacher's episodes without find_object: grasps and pushes take object_ids from lists.

The teacher finds each thing by its place before it touches it, which is a call and four numbers to
copy more than a reader of lists needs. What the other tools reply doesn't depend on it.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace

from probe.agents.phrases import Say
from probe.episodes.participation import ModelReply
from probe.episodes.record import EpisodeRecord, Step
from probe.toolshed.result import MOVING
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.single_calls import seat_of_single_calls
from probe.train.dataset.augment.teacher_words import by_id

_LISTED = re.compile(r"^  object_id: (object_\d+)$", re.MULTILINE)
_ID = re.compile(r"\bobject_\d+\b")
_OCCASIONS = {"grasp": "listed grasp", "push": "listed push"}
_SILENT = ("do grasp", "do push")
_OF_A_LIST = ("mark on", "mark touching", "mark place")
"""Reasons to move what a list tells beside another thing, by its object_id."""
_NAMED_BEFORE = ("place", "obstacle", "hollow", "flat", "unclear", "largest")
"""Other reasons in which an object_id can stand for a name, once both were said."""


@dataclass(frozen=True)
class SayWithoutFinding:
    """Words that speak of no search, and of things by their object_ids; a Say.

    Attributes:
        say: Chooses among phrases.
    """

    say: Say

    def __call__(self, occasion: str, slots: Mapping[str, str]) -> str:
        """Words for an occasion; what is said before a search covers the manipulation after it."""
        if occasion in _SILENT:
            return ""
        kind = occasion.split()[0]
        if kind in _OCCASIONS or not slots.get("id") or "thing" not in slots:
            return self.say(_OCCASIONS.get(occasion, occasion), slots)
        told = {**slots, "thing": slots["id"]}
        if kind == "look" or occasion in _OF_A_LIST:
            return by_id(self.say(occasion, told))
        if kind == "marked":
            return self.say(occasion, slots)
        said = self.say(occasion, told if occasion in _NAMED_BEFORE else slots)
        return f"{self.say('listed thing', slots)} {by_id(said)}"


def without_finding(record: EpisodeRecord) -> EpisodeRecord:
    """An episode whose manipulations take their object_ids from what was listed.

    Args:
        record: What happened in the setting "text-only", in words of SayWithoutFinding.

    Raises:
        NotCertain: A search says something that its list doesn't, nothing is done with it, or its
            agent made several calls at once.
    """
    seat = seat_of_single_calls(record)
    steps, replies = list[Step](), list[ModelReply]()
    listed, words = set[str](), ""
    for index, (step, reply) in enumerate(zip(record.steps, seat.replies, strict=True)):
        if step.call.name == "find_object":
            _check(record, index, listed)
            words = f"{step.call.words} "
            continue
        if step.call.name == "perceive_scene":
            listed = set(_LISTED.findall(step.text))
        if step.call.name in MOVING:
            listed = set[str]()
        call = replace(step.call, words=f"{words}{step.call.words}".strip())
        steps.append(replace(step, call=call))
        replies.append(reply)
        words = ""
    seat = replace(seat, replies=tuple(replies))
    return replace(record, steps=tuple(steps), participation=seat)


def _check(record: EpisodeRecord, index: int, listed: set[str]) -> None:
    """See that a search is followed by a manipulation of something that the last list has."""
    following = record.steps[index + 1] if index + 1 < len(record.steps) else None
    if following is None or following.call.name not in MOVING:
        raise NotCertain(record.task, "nothing is done with what find_object found")
    object_id = following.call.values.get("object_id")
    said = _ID.findall(record.steps[index].call.words)
    if object_id not in listed or (said and said[-1] != object_id):
        raise NotCertain(record.task, "find_object gave an object_id that no list has")
