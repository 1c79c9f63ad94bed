"""What a worker process does in an audit: sets a record's table, does its calls again, compares."""

from __future__ import annotations

from collections.abc import Callable, Generator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import partial

from probe.assets.library import Library
from probe.audit.audit_file import ReplayVerdict
from probe.episodes.participation import has_tools
from probe.episodes.play import replay_afresh
from probe.episodes.record import EpisodeRecord
from probe.episodes.replay import differences
from probe.errors import OutputFailed
from probe.render.renderers import Renderers
from probe.runs.vary import vary
from probe.tasks.suite import Suite, check_objects, part
from probe.tasks.task import Task
from probe.toolshed.version import TOOLS_VERSION

_SHOWN = 4
"""Differences that a verdict names."""


@dataclass(frozen=True)
class Claim:
    """One record to be replayed.

    Attributes:
        line: SHA-256 of its line.
        record: What it says.
        task: What it is about, as in the folder's suite.
        base: The packaged task that this was made from, if it was run under other conditions.
    """

    line: str
    record: EpisodeRecord
    task: Task
    base: Task | None = None


@dataclass(frozen=True)
class Replayer:
    """All that a worker is told; see probe.processes.serving.Opening.

    Attributes:
        suite: The folder's.
        library: Opens the objects; a value that can be sent to another process.
    """

    suite: Suite
    library: Callable[[], Library]

    @contextmanager
    def __call__(self) -> Generator[Callable[[Claim], bytes]]:
        """Open the library and start renderers as records need them; gives what replays a claim."""
        things = self.library()
        with Renderers(things.light_cache) as renderers:
            yield partial(self._verdict, things, renderers)

    def _verdict(self, things: Library, renderers: Renderers, claim: Claim) -> bytes:
        """The verdict as JSON."""
        try:
            check_objects(part(self.suite, claim.task), things)
            reason = _difference(claim, things, renderers)
            verdict = ReplayVerdict(outcome="differs" if reason else "equal", reason=reason)
        except OutputFailed:
            raise  # this machine's disk is full, which says nothing about the record
        except Exception as error:
            # Whatever a record does to the tools is told of this record alone.
            reason = f"{type(error).__name__}: {error}"
            verdict = ReplayVerdict(outcome="not replayable", reason=reason)
        return verdict.model_dump_json().encode()


def unable(record: EpisodeRecord) -> str | None:
    """Why doing a record's calls again can't come out as before; None if it can."""
    if record.tools != TOOLS_VERSION:
        return f"version {record.tools} of the tools made it, and this release has {TOOLS_VERSION}"
    if record.frames:
        return "it was played on a robot, whose table can't be set again"
    if record.perception.kind == "enrolled":
        return f"names came from an enrolment that the folder doesn't hold ({record.label})"
    if record.participation is None:
        return None
    setting, _, more = record.participation.setting.partition(", ")
    if more and setting == "agentic":
        return f"perception asked a model ({more})"
    return None if has_tools(setting) else f"a model answered in words (setting {setting})"


def _difference(claim: Claim, things: Library, renderers: Renderers) -> str:
    """Where a replay comes out otherwise; empty if it doesn't."""
    record, task = claim.record, claim.task
    renderer = renderers[record.viewpoint.renderer]
    if claim.base is not None:
        (made,) = vary((claim.base,), record.conditions, things, renderer)
        if made.task != task:
            return "its table isn't what its conditions make of the packaged task"
    found = differences(record, replay_afresh(task, record, things, renderer))
    more = f", and {len(found) - _SHOWN} more" if len(found) > _SHOWN else ""
    return ", ".join(found[:_SHOWN]) + more
