"""Checks a session afterwards: that seals, records, order and verdicts are what the log says."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import zip_longest
from pathlib import Path

from probe.episodes.files import lines_of, record_of
from probe.episodes.folder import RECORDS, SUITE
from probe.episodes.record import EpisodeRecord
from probe.runs.session.events import Ended, OfSlot, Reasoned, Sealed, Unblinded
from probe.runs.session.log import begun_in, read_log
from probe.runs.session.order import Slot, slots_of
from probe.runs.session.seal import Truth, seal_of
from probe.runs.session.session import tables_of, verdict_of
from probe.runs.session.standing import SlotState, digest_of, state_of
from probe.tasks.suite import Suite
from probe.tasks.suite_file import content_hash, read_suite

Records = Mapping[str, EpisodeRecord]
"""By the digest of their lines."""


@dataclass(frozen=True)
class Account:
    """What a session came to, and what is wrong with it.

    Attributes:
        wanted: Episodes that there were to be.
        results: Those that have a result.
        interrupted: Tries that were interrupted.
        seals: Truths that were sealed and opened.
        finished: Whether it was told who was who.
        amiss: What doesn't agree, in words; empty if all does.
    """

    wanted: int
    results: int
    interrupted: int
    seals: int
    finished: bool
    amiss: tuple[str, ...]


def account_of(out: Path) -> Account:
    """Check a session's folder.

    Raises:
        BadData: A file can't be read, or a line of the log was changed or left out.
    """
    events, suite = read_log(out), read_suite(out / SUITE)
    begun, records = begun_in(events, out), _records(out)
    slots = slots_of(begun.plan, begun.agents)
    states = {slot: state_of(slot, events) for slot in slots}
    amiss = list[str]()
    if begun.suite != content_hash(suite):
        amiss.append(f"{SUITE} isn't the suite that the session began with")
    known = {slot.key for slot in slots}
    if any(isinstance(it, OfSlot) and it.of not in known for it in events):
        amiss.append("the log tells of episodes that aren't in its plan")
    if any(isinstance(it, Unblinded) and it.agents != tables_of(slots) for it in events):
        amiss.append("its agents weren't who the log says")
    ends = [it for it in events if isinstance(it, Ended)]
    if strange := len(records.keys() - {end.record for end in ends}):
        amiss.append(f"{strange} records aren't in the log")
    for slot, state in states.items():
        named = f"{slot.task}, run {slot.run}, agent {slot.number}"
        amiss += [f"{named}: {words}" for words in _of_slot(slot, state, suite, records)]
    return Account(
        wanted=len(slots),
        results=sum(state.result is not None for state in states.values()),
        interrupted=sum(state.interrupted for state in states.values()),
        seals=sum(end.opened is not None for end in ends),
        finished=isinstance(events[-1], Unblinded),
        amiss=tuple(amiss),
    )


def _records(out: Path) -> Records:
    path = out / RECORDS
    lines = lines_of(path) if path.exists() else []
    return {digest_of(line + b"\n"): record_of(line) for line in lines}


def _of_slot(slot: Slot, state: SlotState, suite: Suite, records: Records) -> Iterator[str]:
    seal: str | None = None
    for event, after in zip_longest(state.events, state.events[1:]):
        if isinstance(event, Sealed):
            seal = event.seal
        elif isinstance(event, Ended):
            yield from _of_seal(event, seal, suite[slot.task].answer)
            record = records.get(event.record or "")
            if record is not None:
                yield from _of_record(event, record, slot)
            elif event.record is not None and isinstance(after, Reasoned):
                yield "its record is missing, or was changed"
            seal = None


def _of_seal(end: Ended, seal: str | None, answer: str) -> Iterator[str]:
    if seal is None:
        yield "it ended without a sealed truth"
    elif end.opened is None:
        if end.verdict != "interrupted":
            yield "its seal was never opened"
    elif seal_of(Truth(**end.opened.model_dump())) != seal:
        yield "its truth isn't what was sealed"
    elif end.opened.answer != answer:
        yield "its truth isn't the suite's"


def _of_record(end: Ended, record: EpisodeRecord, slot: Slot) -> Iterator[str]:
    if (record.task, record.agent, record.run) != (slot.task, slot.agent, slot.run):
        yield "its record is of another episode"
    if end.opened and verdict_of(record, Truth(**end.opened.model_dump())) != end.verdict:
        yield "its verdict isn't what its record is worth"
