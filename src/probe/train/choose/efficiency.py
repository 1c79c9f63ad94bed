"""Whether an episode went straight to its answer, by a stated rule. Pure."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from statistics import median_low
from typing import Literal

from probe.agents.reading import read_handles, read_new_handle
from probe.episodes.record import EpisodeRecord, Step
from probe.toolshed.result import DID_NOTHING, MOVING

Waste = Literal[
    "too many manipulations", "failed twice at one thing", "a call or reply that did nothing"
]

_LOOKS = ("perceive_scene", "find_object")
SLACK = 1
"""Manipulations more than the median of a type's successes that are let pass."""


def limits(successes: Iterable[tuple[str, EpisodeRecord]], slack: int = SLACK) -> Mapping[str, int]:
    """The most manipulations of an efficient episode, by type.

    Args:
        successes: Type and record of all episodes with tools that were right.
        slack: Added to each type's median.
    """
    counts: dict[str, list[int]] = {}
    for question_type, record in successes:
        counts.setdefault(question_type, []).append(record.manipulations)
    return {question_type: median_low(values) + slack for question_type, values in counts.items()}


def waste(record: EpisodeRecord, limit: int) -> Waste | None:
    """What an episode wasted; None if it is efficient.

    It may take `limit` manipulations; no thing may have withstood more than one of them; each call
    must have been one that the tools could do; and no reply may have needed a reminder.
    """
    if record.manipulations > limit:
        return "too many manipulations"
    if any(count > 1 for count in failures(record).values()):
        return "failed twice at one thing"
    if reminded(record) or any(step.status in DID_NOTHING for step in record.steps):
        return "a call or reply that did nothing"
    return None


def reminded(record: EpisodeRecord) -> bool:
    """Whether a model had to be told to call a tool, to answer, or to point at its answer."""
    # Only an episode's last reply may be in words alone.
    return record.participation is not None and any(
        it.calls == 0 for it in record.participation.replies[:-1]
    )


def failures(record: EpisodeRecord) -> Counter[str]:
    """How often a manipulation failed, by what the tools said the thing was."""
    called: dict[str, str] = {}
    failed = Counter[str]()
    for step in record.steps:
        if step.call.name in _LOOKS:
            called |= read_handles(step.text)
        elif step.call.name in MOVING:
            handle = _handle(step)
            what = called.get(handle, handle)
            if step.status == "failed":
                failed[what] += 1
            if renamed := read_new_handle(step.text):
                called[renamed] = what
    return failed


def _handle(step: Step) -> str:
    values = step.call.values
    return str(values.get("object_id", "")) if isinstance(values, dict) else ""
