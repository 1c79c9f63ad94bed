"""An episode as it would have gone if table, arm and camera were mirrored, left to right.

Only what is said is mirrored, as far as an example tells it. The scenes of the record stay.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace
from typing import Any, cast

from probe.episodes.participation import Points
from probe.episodes.record import EpisodeRecord, Step
from probe.episodes.turns import Call, Question
from probe.generation.task_writer import asked
from probe.tasks.task import Task
from probe.toolshed.result import DID_NOTHING, MOVING
from probe.train.dataset.augment.certain import NotCertain, has_sides
from probe.train.dataset.augment.listing import ListedThing, read_listing
from probe.train.dataset.augment.mirrored_list import level, mirrored_list, mirrored_place
from probe.train.dataset.augment.mirrored_reply import (
    mirrored_reply,
    orders_level_things,
    orders_others,
)
from probe.train.dataset.augment.rewording import worded
from probe.train.dataset.augment.teacher_words import MIRRORED_DIRECTION, mirrored_words
from probe.transcripts.coordinates import as_whole, told
from probe.transcripts.messages import participation_of

_PLACE = re.compile(r"\(\d+, \d+\)")
_ID = re.compile(r"\bobject_\d+\b")


def mirrored(task: Task, record: EpisodeRecord) -> EpisodeRecord:
    """An episode as examples tell it, mirrored.

    Args:
        task: What it is about.
        record: What happened.

    Raises:
        NotCertain: A text in it can't be mirrored for sure.
    """
    seat = participation_of(record)
    if any(reply.words for reply in seat.replies):
        raise NotCertain(record.task, "its teacher spoke freely")
    telling = _Telling(task, record.scale.side_px, seat.points)
    question = _question(task, record)
    return replace(
        record, question=question, steps=tuple(telling.step(step) for step in record.steps)
    )


def _question(task: Task, record: EpisodeRecord) -> Question:
    """The same question with the marks where they would be."""
    known, side_px = worded(task, record), record.scale.side_px
    named = "\n".join([*known.slots.values(), *(text for _, text in record.question.options)])
    if has_sides(named) or has_sides(task.form):
        raise NotCertain(record.task, "its question speaks of a side")
    marks = [replace(it, point=mirrored_place(it.point, side_px)) for it in task.marks]
    return replace(record.question, text=asked(known.wording.text, known.slots, marks))


@dataclass
class _Telling:
    """One episode's steps, one after another.

    Attributes:
        task: Whose marks the teacher may name by their places.
        side_px: Width of its pictures.
        points: How the agent counts places.
        renamed: New object_ids of those that the tools would have given out in another order.
        known: All object_ids so far.
        listed: What the last list had.
        listed_now: Whether nothing has been moved since.
        moved: Whether anything has been moved at all.
        level: Object_ids of two that were equally high in a list.
    """

    task: Task
    side_px: int
    points: Points
    renamed: dict[str, str] = field(default_factory=dict[str, str])
    known: set[str] = field(default_factory=set[str])
    listed: tuple[ListedThing, ...] = ()
    listed_now: bool = False
    moved: bool = False
    level: set[frozenset[str]] = field(default_factory=set[frozenset[str]])

    def step(self, step: Step) -> Step:
        """The next step, mirrored.

        Raises:
            NotCertain: It can't be.
        """
        if step.status in DID_NOTHING and step.call.name != "answer_question":
            raise NotCertain(self.task.id, "a call was refused")
        call, name = self._call(step.call), step.call.name
        text = self._list(step.text) if name == "perceive_scene" else self._reply(step.text, name)
        self.known |= set(_ID.findall(step.text))
        if name in MOVING:
            self.moved, self.listed_now = True, False
        return replace(step, call=call, text=self._with_new_ids(text))

    def _with_new_ids(self, text: str) -> str:
        return _ID.sub(lambda found: self.renamed.get(found[0], found[0]), text)

    def _list(self, text: str) -> str:
        listing = read_listing(text)
        if listing is None or any(has_sides(it.words) for it in listing.things):
            raise NotCertain(self.task.id, "a list has another form, or words for sides")
        mirror = mirrored_list(listing, self.side_px)
        new = [it.object_id for it in listing.things if it.object_id not in self.known]
        if self.moved:
            # Those that a grasp or a push has moved got theirs before the list was made.
            if any({a.object_id, b.object_id} <= {*new} for a, b in level(listing.things)):
                raise NotCertain(self.task.id, "equally high things got their object_ids late")
        else:
            anew = [it.object_id for it in mirror.things if it.object_id in new]
            self.renamed |= dict(zip(anew, new, strict=True))
        self.listed, self.listed_now = listing.things, True
        self.level |= {frozenset((a.object_id, b.object_id)) for a, b in level(self.listed)}
        return mirror.text

    def _reply(self, text: str, tool: str) -> str:
        mirror = mirrored_reply(text, self.side_px)
        if mirror is None:
            raise NotCertain(self.task.id, "a reply speaks of sides in other words")
        if tool == "find_object" and orders_level_things(text):
            raise NotCertain(self.task.id, "find_object chose among equally high things")
        unsure = not self.listed_now or level(self.listed)
        if tool in MOVING and unsure and orders_others(text):
            raise NotCertain(self.task.id, "several moved in an order that no list tells")
        return mirror

    def _call(self, call: Call) -> Call:
        if not isinstance(call.values, dict) or call != Call.of(call.name, call.values, call.words):
            raise NotCertain(self.task.id, "a call is written in another way")
        said = dict(cast("dict[str, Any]", call.values))
        direction = str(said.get("direction")) if call.name == "push" else None
        words = mirrored_words(call.words, direction)
        if words is None:
            raise NotCertain(self.task.id, "its teacher spoke freely")
        if any(pair <= {*_ID.findall(words)} for pair in self.level):
            raise NotCertain(self.task.id, "its teacher names equally high things in an order")
        words = self._with_marks(self._with_new_ids(words))
        if call.name == "find_object" or "point" in said:
            return self._pointing(call, words)
        if "object_id" in said:
            said["object_id"] = self._with_new_ids(str(said["object_id"]))
        if direction is not None:
            said["direction"] = MIRRORED_DIRECTION[direction]
        return Call.of(call.name, said, words)

    def _with_marks(self, words: str) -> str:
        """Words that name marks by where they would be."""
        points = [mark.point for mark in self.task.marks]
        before, after = (
            [told(str(tuple(point)), self.points) for point in places]
            for places in (points, [mirrored_place(point, self.side_px) for point in points])
        )
        places = dict(zip(before, after, strict=True))
        if not {*_PLACE.findall(words)} <= places.keys():
            raise NotCertain(self.task.id, "its teacher names a place that isn't a mark's")
        return _PLACE.sub(lambda found: places[found[0]], words)

    def _pointing(self, call: Call, words: str) -> Call:
        """A call with a place that the last list told, as the agent counts places."""
        found = {it.point for it in self.listed if self._naming(call, it.point, call.words) == call}
        if len(found) != 1:
            raise NotCertain(self.task.id, "a call has a place that the last list doesn't tell")
        return self._naming(call, mirrored_place(found.pop(), self.side_px), words)

    def _naming(self, call: Call, place: tuple[int, int], words: str) -> Call:
        """The same call with another place."""
        if call.name == "find_object":
            values = {"description": f"the thing at ({place[0]}, {place[1]})"}
        else:
            values = {**call.values, "point": list(place)}
        return as_whole(Call.of(call.name, values, words), self.points)
