"""The same episode with a slip: something is asked for by an object_id that doesn't hold.

The scripted teacher makes none, so its student never reads what to do after one. The slip itself
isn't learnt, as it is refused (probe.train.dataset.examples); what follows it is.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import accumulate

import numpy as np

from probe.agents.phrases import Say
from probe.episodes.participation import ModelReply
from probe.episodes.record import EpisodeRecord, Step
from probe.episodes.turns import Call
from probe.toolshed.refusals import StaleHandle, UnknownHandle
from probe.toolshed.result import MOVING
from probe.toolshed.toolshed import MANIPULATIONS, TURNS
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.listing import read_listing
from probe.train.dataset.augment.retelling import check_scripted
from probe.train.dataset.augment.single_calls import seat_of_single_calls

_Names = Mapping[str, str | None]


def with_a_slip(record: EpisodeRecord, rng: np.random.Generator, say: Say) -> EpisodeRecord:
    """An episode in which, at one point, a call has an object_id that doesn't hold.

    Either an earlier turn is said once more, or the turn that comes is said with an object_id that
    its thing had before, or the first manipulation comes before anything was listed. The reply
    refuses it, which costs no manipulation; the teacher looks, and goes on with what it did at this
    point.

    Args:
        record: What happened, in the setting "text-only".
        rng: Chooses when, and which slip.
        say: Gives the words of the look.

    Raises:
        NotCertain: The scripted teacher didn't teach, or finds things by find_object before it
            moves them; it moves nothing, or not after a list; or no turns are left.
    """
    check_scripted(record)
    seat = seat_of_single_calls(record)
    if any(step.call.name == "find_object" for step in record.steps):
        raise NotCertain(record.task, "its teacher finds things before it moves them")
    if len(record.steps) + 2 > TURNS:
        raise NotCertain(record.task, "it has no turns left for a slip")
    lists = [_names(step) for step in record.steps]
    decisions = _decisions(record, lists)
    by_place = {at: slips for at in decisions if (slips := _slips(record, lists, at))}
    by_place |= {0: early} if (early := _early(record)) else {}
    if not by_place:
        raise NotCertain(record.task, "it moves nothing that it listed")
    at = int(rng.choice([*by_place]))
    slip = by_place[at][int(rng.integers(len(by_place[at])))]
    more = _refused(slip, record.steps[at - 1], say) if at else (slip,)
    steps = [*record.steps[:at], *more, *record.steps[at:]]
    replies = [*seat.replies[:at], *(ModelReply(1) for _ in more), *seat.replies[at:]]
    return replace(record, steps=tuple(steps), participation=replace(seat, replies=tuple(replies)))


def _early(record: EpisodeRecord) -> list[Step]:
    """The first manipulation before the first list, refused; none if a list doesn't come first."""
    first, *later = record.steps
    move = next((step for step in later if step.call.name in MOVING), None)
    if first.call.name != "perceive_scene" or move is None:
        return []
    text = str(UnknownHandle(_object_id(move), ()))
    return [replace(move, status="malformed", text=text, point_px=None, after=record.start)]


def _decisions(record: EpisodeRecord, lists: Sequence[_Names | None]) -> list[int]:
    """The steps that follow a list, as long as manipulations are left.

    After that the tools refuse a manipulation for another reason.
    """
    allowed = record.question.manipulations or MANIPULATIONS
    spent = list(accumulate((step.call.name in MOVING for step in record.steps), initial=0))
    return [
        at
        for at in range(1, len(record.steps))
        if record.steps[at].call.name != "perceive_scene"
        and lists[at - 1] is not None
        and spent[at] < allowed
    ]


def _slips(record: EpisodeRecord, lists: Sequence[_Names | None], at: int) -> list[Step]:
    """Manipulations with an object_id that the list before a step hasn't any more.

    What couldn't be moved may be as it was, under an older object_id.
    """
    names = lists[at - 1] or {}
    moved = [it for it in record.steps[: at - 1] if it.call.name in MOVING and it.status == "done"]
    again = [it for it in moved if _object_id(it) not in names]
    before = [it for it in lists[: at - 1] if it is not None]
    return [*again, *_by_former_ids(record.steps[at], names, before)]


def _by_former_ids(step: Step, names: _Names, before: Sequence[_Names]) -> Iterator[Step]:
    """A manipulation by each object_id that its thing had before, if just one has its name.

    Of several object_ids that hold, lists tell the oldest: one that is older than that doesn't.
    """
    name = names.get(_object_id(step)) if step.call.name in MOVING else None
    if name is None or _ids(names, name) != [_object_id(step)]:
        return
    former = dict.fromkeys(ids[0] for it in before if len(ids := _ids(it, name)) == 1)
    for id in (it for it in former if _number(it) < _number(_object_id(step))):
        now = re.compile(rf"\b{_object_id(step)}\b")
        words, arguments = (now.sub(id, it) for it in (step.call.words, step.call.arguments))
        yield replace(step, call=replace(step.call, words=words, arguments=arguments))


def _ids(names: _Names, name: str) -> list[str]:
    return [id for id, it in names.items() if it == name]


def _names(step: Step) -> _Names | None:
    """Names of what a step's list has, by object_id; None where it has no list."""
    listing = read_listing(step.text)
    return None if listing is None else {it.object_id: it.name for it in listing.things}


def _refused(slip: Step, look: Step, say: Say) -> tuple[Step, Step]:
    """A call that is refused, and a look that shows what the last one did."""
    id = _object_id(slip)
    text = str(StaleHandle(id))
    refused = replace(slip, status="malformed", text=text, point_px=None, after=look.after)
    words = say("look refused", {"id": id})
    return refused, replace(look, call=Call.of("perceive_scene", words=words))


def _number(object_id: str) -> int:
    return int(object_id.rpartition("_")[2])


def _object_id(step: Step) -> str:
    return step.call.values["object_id"]
