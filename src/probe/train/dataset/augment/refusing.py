"""The same episode with a slip: something is asked for by an object_id that is out of date.

The scripted teacher makes none, so its student never reads what to do after one. The slip itself
isn't learnt, as it is refused (probe.train.dataset.examples); what follows it is.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from probe.agents.phrases import Say
from probe.episodes.participation import ModelReply
from probe.episodes.record import EpisodeRecord, Step
from probe.episodes.turns import Call
from probe.toolshed.refusals import StaleHandle
from probe.toolshed.result import MOVING
from probe.toolshed.toolshed import TURNS
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.listing import read_listing
from probe.transcripts.messages import PLAIN


def with_a_slip(record: EpisodeRecord, rng: np.random.Generator, say: Say) -> EpisodeRecord:
    """An episode in which an earlier turn is said once more, when its object_id is out of date.

    The reply refuses it, which costs no manipulation; the teacher looks again, and goes on with
    what it did at this point.

    Args:
        record: What happened, in the setting "text-only".
        rng: Chooses which turn is said again, and when.
        say: Gives the words of the look.

    Raises:
        NotCertain: Nothing that was moved is out of date when something else is done, no turns are
            left for it, or its agent made several calls at once.
    """
    seat = record.participation or PLAIN
    if any(reply.calls != 1 for reply in seat.replies) or len(seat.replies) != len(record.steps):
        raise NotCertain(record.task, "its agent made several calls at once, or none")
    if len(record.steps) + 2 > TURNS:
        raise NotCertain(record.task, "it has no turns left for a slip")
    slips = [(at, it) for at in _decisions(record) for it in _out_of_date(record, at)]
    if not slips:
        raise NotCertain(record.task, "nothing is out of date when something else is done")
    at, earlier = slips[int(rng.integers(len(slips)))]
    steps = [*record.steps[:at], *_slip(record, at, earlier, say), *record.steps[at:]]
    replies = [*seat.replies[:at], ModelReply(1), ModelReply(1), *seat.replies[at:]]
    return replace(record, steps=tuple(steps), participation=replace(seat, replies=tuple(replies)))


def _decisions(record: EpisodeRecord) -> list[int]:
    """The steps that follow a list."""
    return [
        at
        for at in range(1, len(record.steps))
        if record.steps[at - 1].call.name == "perceive_scene"
        and record.steps[at].call.name != "perceive_scene"
    ]


def _out_of_date(record: EpisodeRecord, at: int) -> list[int]:
    """Earlier manipulations of what the list before a step has under no object_id of theirs."""
    listing = read_listing(record.steps[at - 1].text)
    listed = {thing.object_id for thing in listing.things} if listing else set[str]()
    return [
        earlier
        for earlier in range(at - 1)
        if record.steps[earlier].call.name in MOVING
        and _object_id(record.steps[earlier]) not in listed
    ]


def _slip(record: EpisodeRecord, at: int, earlier: int, say: Say) -> tuple[Step, Step]:
    """The turn that is said again with its refusal, and the look after it."""
    again, look = record.steps[earlier], record.steps[at - 1]
    id = _object_id(again)
    text = str(StaleHandle(id))
    refused = replace(again, status="malformed", text=text, point_px=None, after=look.after)
    words = say("look blocked", {"thing": _name(record, earlier, id), "id": id})
    return refused, replace(look, call=Call.of("perceive_scene", words=words))


def _object_id(step: Step) -> str:
    return step.call.values["object_id"]


def _name(record: EpisodeRecord, before: int, id: str) -> str:
    """What has an object_id in the last list before a step that has it and names it."""
    listings = (read_listing(step.text) for step in reversed(record.steps[:before]))
    things = (thing for listing in listings if listing for thing in listing.things)
    return next((it.name for it in things if it.object_id == id and it.name), "thing")
