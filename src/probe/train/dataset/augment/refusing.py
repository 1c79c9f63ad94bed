"""The same episode with a slip: something is asked for by an object_id that is out of date.

The scripted teacher makes none, so its student never reads what to do after one. The slip itself
isn't learnt, as it is refused (probe.train.dataset.examples); what follows it is.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
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
    """An episode in which, at one point, a call asks for what is out of date.

    Either an earlier turn is said once more, or the turn that comes is said with an object_id that
    its thing had before. The reply refuses it, which costs no manipulation; the teacher looks
    again, and goes on with what it did at this point.

    Args:
        record: What happened, in the setting "text-only".
        rng: Chooses when, and which slip.
        say: Gives the words of the look.

    Raises:
        NotCertain: Nothing is out of date that the teacher moved or moves next, no turns are left
            for it, or its agent made several calls at once.
    """
    seat = record.participation or PLAIN
    if any(reply.calls != 1 for reply in seat.replies) or len(seat.replies) != len(record.steps):
        raise NotCertain(record.task, "its agent made several calls at once, or none")
    if len(record.steps) + 2 > TURNS:
        raise NotCertain(record.task, "it has no turns left for a slip")
    by_place = {at: slips for at in _decisions(record) if (slips := _slips(record, at))}
    if not by_place:
        raise NotCertain(record.task, "nothing is out of date that it moved or moves next")
    at = int(rng.choice([*by_place]))
    slip = by_place[at][int(rng.integers(len(by_place[at])))]
    steps = [*record.steps[:at], *_refused(slip, record.steps[at - 1], say), *record.steps[at:]]
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


def _slips(record: EpisodeRecord, at: int) -> list[Step]:
    """Manipulations with an object_id that the list before a step hasn't any more."""
    names = _names(record.steps[at - 1])
    earlier = [it for it in record.steps[: at - 1] if it.call.name in MOVING]
    again = [it for it in earlier if _object_id(it) not in names]
    return [*again, *_by_former_ids(record, at, names)]


def _by_former_ids(
    record: EpisodeRecord, at: int, names: Mapping[str, str | None]
) -> Iterator[Step]:
    """A manipulation by each object_id that its thing had before, if just one has its name."""
    step = record.steps[at]
    name = names.get(_object_id(step)) if step.call.name in MOVING else None
    if name is None or _ids(names, name) != [_object_id(step)]:
        return
    lists = (_ids(_names(it), name) for it in record.steps[: at - 1])
    former = dict.fromkeys(ids[0] for ids in lists if len(ids) == 1)
    for id in (it for it in former if it not in names):
        now = re.compile(rf"\b{_object_id(step)}\b")
        words, arguments = (now.sub(id, it) for it in (step.call.words, step.call.arguments))
        yield replace(step, call=replace(step.call, words=words, arguments=arguments))


def _ids(names: Mapping[str, str | None], name: str) -> list[str]:
    return [id for id, it in names.items() if it == name]


def _names(step: Step) -> dict[str, str | None]:
    """Names of what a step's list has, by object_id."""
    listing = read_listing(step.text)
    return {it.object_id: it.name for it in listing.things} if listing else {}


def _refused(slip: Step, look: Step, say: Say) -> tuple[Step, Step]:
    """A call that is refused, and a look that shows what the last one did."""
    id = _object_id(slip)
    text = str(StaleHandle(id))
    refused = replace(slip, status="malformed", text=text, point_px=None, after=look.after)
    words = say("look refused", {"thing": id, "id": id})
    return refused, replace(look, call=Call.of("perceive_scene", words=words))


def _object_id(step: Step) -> str:
    return step.call.values["object_id"]
