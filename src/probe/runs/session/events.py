"""What a session's log tells, event by event."""

from __future__ import annotations

from typing import Annotated, Literal

import pydantic

from probe.runs.session.plan import SessionPlan

Verdict = Literal["right", "wrong", "interrupted"]


class _Event(pydantic.BaseModel, frozen=True, extra="forbid"):
    pass


class Begun(_Event, frozen=True):
    """The session starts: its plan, the agents' names, and SHA-256 of what its suite holds."""

    what: Literal["begun"] = "begun"
    plan: SessionPlan
    agents: tuple[str, ...]
    suite: str


class SlotKey(_Event, frozen=True):
    """Which episode of a session, without saying whose it is; see Slot."""

    task: str
    run: int
    number: int


class Opened(_Event, frozen=True):
    """What was sealed; see probe.runs.session.seal."""

    answer: str
    note: str
    salt: str


class _OfSlot(_Event, frozen=True):
    of: SlotKey


class Sealed(_OfSlot, frozen=True):
    """A table is laid and its truth sealed; the agent may start."""

    what: Literal["sealed"] = "sealed"
    seal: str


class Ended(_OfSlot, frozen=True):
    """An episode is over, and its seal opened.

    Attributes:
        verdict: By the sealed truth; "interrupted" is neither right nor wrong.
        record: SHA-256 of the line of its record, which is added next; None if there is none.
        answer: The agent's letter, if it gave one.
        fault: What interrupted it.
        opened: What was sealed; None where the session itself stopped in the episode's midst.
    """

    what: Literal["ended"] = "ended"
    verdict: Verdict
    record: str | None = None
    answer: str | None = None
    fault: str | None = None
    opened: Opened | None = None


class Reasoned(_OfSlot, frozen=True):
    """What the operator saw happen, in their words."""

    what: Literal["reasoned"] = "reasoned"
    words: str


class Lost(_OfSlot, frozen=True):
    """An episode ended, but its record was never written: it counts as interrupted."""

    what: Literal["lost"] = "lost"


class Unblinded(_Event, frozen=True):
    """The session is over, and who was who is told: agents of each task and run, by number."""

    what: Literal["unblinded"] = "unblinded"
    agents: tuple[tuple[str, int, tuple[str, ...]], ...]


Event = Begun | Sealed | Ended | Reasoned | Lost | Unblinded
OfSlot = Sealed | Ended | Reasoned | Lost


class Entry(pydantic.BaseModel, frozen=True, extra="forbid"):
    """A line of the log.

    Attributes:
        at: When, UTC, ISO 8601.
        before: SHA-256 of the line before, checksum and line end included; empty on the first.
        event: What.
    """

    at: str
    before: str
    event: Annotated[Event, pydantic.Field(discriminator="what")]
