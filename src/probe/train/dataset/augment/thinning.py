"""The same episode at a table with fewer things: lists leave out some that nobody speaks of.

Shorter lists take less time to learn from, and have less in them to mix up.
"""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Collection
from dataclasses import replace
from functools import lru_cache

import numpy as np

from probe.agents.phrases import Say, phrases
from probe.episodes.record import EpisodeRecord
from probe.tasks.task import Task
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.listing import Listing, read_listing
from probe.train.dataset.augment.retelling import check_scripted, retold

_SHARE = 0.7
"""Of what nobody speaks of."""
_ALL_LISTED = ("gone through", "gone through later", "moved")
_ID = re.compile(r"\bobject_\d+\b")


def thinned(
    task: Task, record: EpisodeRecord, rng: np.random.Generator, say: Say
) -> tuple[Task, EpisodeRecord]:
    """A task and an episode whose lists leave out things.

    Left out are things that have a name in all lists, which neither the question nor a reply, a
    call or the teacher's words speak of. The scripted teacher must make the same calls.

    Args:
        task: What the episode is about.
        record: What happened.
        rng: Chooses what is left out.
        say: Chooses the teacher's words.

    Raises:
        NotCertain: There is nothing to leave out, or the teacher isn't the scripted one or would
            do something else.
    """
    check_scripted(record)
    idle = [name for name in _unspoken(record) if rng.random() < _SHARE]
    if not idle:
        raise NotCertain(record.task, "its question or its teacher speaks of all things")
    return retold(task, record, lambda text: _without(text, idle), say)


def _unspoken(record: EpisodeRecord) -> list[str]:
    """Names of things that nobody speaks of, sorted."""
    ids = defaultdict[str | None, set[str]](set)
    spoken = [record.question.text, *(text for _, text in record.question.options)]
    everything = _gone_through()
    for step in record.steps:
        spoken += [everything.sub("", step.call.words), step.call.arguments]
        listing = read_listing(step.text)
        if listing is None:
            spoken.append(step.text)
        for thing in listing.things if listing else ():
            ids[thing.name].add(thing.object_id)
    text = "\n".join(spoken)
    known = {*_ID.findall(text)} | ids.pop(None, set())
    return sorted(name for name in ids if name and name not in text and not ids[name] & known)


@lru_cache(1)
def _gone_through() -> re.Pattern[str]:
    """Where the teacher names all that is listed, or all that has moved, whatever that is."""
    known = phrases()
    ways = [way for occasion in _ALL_LISTED for way in known[occasion]]
    return re.compile("|".join(re.escape(way).replace(r"\{each\}", "[^.]*") for way in ways))


def _without(text: str, names: Collection[str]) -> str:
    """A list without some things; any other text as it is."""
    listing = read_listing(text)
    return text if listing is None else _shortened(listing, names).text


def _shortened(listing: Listing, names: Collection[str]) -> Listing:
    kept = [n for n, thing in enumerate(listing.things) if thing.name not in names]
    now = {old: new for new, old in enumerate(kept)}
    return replace(
        listing,
        things=tuple(listing.things[n] for n in kept),
        relations=tuple(
            (now[a], kind, now[b]) for a, kind, b in listing.relations if a in now and b in now
        ),
    )
