"""How far a session has got, from its log and its records."""

from __future__ import annotations

import hashlib
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from pathlib import Path

from probe.engines.plan import TRIES
from probe.episodes.files import lines_of
from probe.episodes.folder import RECORDS
from probe.runs.session.events import Ended, Event, Lost, OfSlot, Reasoned, Sealed
from probe.runs.session.order import Slot

STOPPED = "the session stopped in its midst"


@dataclass(frozen=True)
class SlotState:
    """How far one episode has got.

    Attributes:
        events: What the log says of it, in order.
    """

    events: tuple[OfSlot, ...] = ()

    @property
    def tries(self) -> int:
        """How often an agent was let at it."""
        return sum(isinstance(it, Sealed) for it in self.events)

    @property
    def result(self) -> Ended | None:
        """Its end by an answer, or by the agent's own doing."""
        last = self.end
        return last if last and last.verdict != "interrupted" and not self._lost else None

    @property
    def interrupted(self) -> int:
        """Tries that came to nothing through no fault of the agent."""
        return self.tries - (self.result is not None)

    @property
    def over(self) -> bool:
        """Whether nothing more is done about it: it has a result, or was tried often enough."""
        return self.result is not None or (self.tries >= TRIES and self.settled)

    @property
    def settled(self) -> bool:
        """Whether its last try has an end and the operator's words."""
        return not self.events or isinstance(self.events[-1], Reasoned)

    @property
    def end(self) -> Ended | None:
        """The end of its last try, if that has one."""
        ends = [it for it in self.events if isinstance(it, Ended | Sealed)]
        return ends[-1] if ends and isinstance(ends[-1], Ended) else None

    @property
    def words(self) -> str:
        """What the operator wrote last."""
        return next((it.words for it in reversed(self.events) if isinstance(it, Reasoned)), "")

    @property
    def _lost(self) -> bool:
        last = max(number for number, it in enumerate(self.events) if isinstance(it, Ended))
        return any(isinstance(it, Lost) for it in self.events[last:])


def state_of(slot: Slot, events: Sequence[Event]) -> SlotState:
    """What a log says of an episode."""
    mine = [it for it in events if isinstance(it, OfSlot) and it.of == slot.key]
    return SlotState(tuple(mine))


def digests_in(out: Path) -> set[str]:
    """SHA-256 of the line of each record in a folder."""
    path = out / RECORDS
    lines = lines_of(path) if path.exists() else []
    return {digest_of(line + b"\n") for line in lines}


def digest_of(line: bytes) -> str:
    """SHA-256 of a record's line, its end included; hex digits."""
    return hashlib.sha256(line).hexdigest()


def repair_of(slot: Slot, state: SlotState, records: Collection[str]) -> Ended | Lost | None:
    """What to add to a log that ends in the midst of an episode, before the session goes on."""
    last = state.events[-1] if state.events else None
    if isinstance(last, Sealed):
        return Ended(of=slot.key, verdict="interrupted", fault=STOPPED)
    if isinstance(last, Ended) and last.record is not None and last.record not in records:
        return Lost(of=slot.key)
    return None
