"""Does a recorded episode's calls again on a fresh table, and says where the two differ."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from probe.episodes.episode import Episode, StateReader
from probe.episodes.files import line_of
from probe.episodes.record import EpisodeRecord
from probe.episodes.run import run_episode
from probe.episodes.turns import Call, Question, Turn
from probe.errors import ProbeError
from probe.toolshed.toolshed import Toolshed
from probe.toolshed.version import TOOLS_VERSION, release_words

_FIELDS = (
    "task",
    "agent",
    "run",
    "question",
    "start",
    "answer",
    "end",
    "fault",
    "noise",
    "conditions",
    "viewpoint",
    "participation",
    "tools",
    "perception",
)
_PARTS = ("call", "status", "text", "point_px", "after")


class OtherTools(ProbeError):
    """A record can't be repeated with the tools of this release."""

    def __init__(self, record: EpisodeRecord) -> None:
        super().__init__(
            f"{record.task} by {record.agent} was played with version {record.tools} of the tools, "
            f"and this release has version {TOOLS_VERSION}: its calls can't be done again here. "
            f"Install {release_words(record.tools)} for that. Grading and reports need no replay."
        )


def check_tools(record: EpisodeRecord) -> None:
    """See that a record was made by the tools of this release.

    Raises:
        OtherTools: It wasn't.
    """
    if record.tools != TOOLS_VERSION:
        raise OtherTools(record)


class NotAsBefore(ProbeError):
    """Doing a record's calls again came out otherwise."""

    def __init__(self, record: EpisodeRecord, found: Sequence[str]) -> None:
        super().__init__(
            f"The table of {record.task} can't be set as {record.agent} left it: "
            f"{', '.join(found)}. Go on with the release, the assets and the kind of machine "
            "that it was begun with."
        )


class Recorded:
    """Makes the same calls as in a record, whatever comes of them; an Agent."""

    def __init__(self, record: EpisodeRecord) -> None:
        self._calls = [step.call for step in record.steps]

    def act(self, question: Question, history: Sequence[Turn]) -> Call | None:
        """The call that was made at this point; None after the last one."""
        return self._calls[len(history)] if len(history) < len(self._calls) else None


def replay(record: EpisodeRecord, toolshed: Toolshed, state: StateReader) -> EpisodeRecord:
    """Do an episode's calls again.

    Args:
        record: What happened the first time.
        toolshed: Fresh, over a table that stands as at the record's start, with the record's
            circumstances.
        state: Tells the new record where things are.

    Raises:
        OtherTools: Tools of another version made it.
    """
    check_tools(record)
    again = run_episode(
        record.task,
        record.question,
        Recorded(record),
        toolshed,
        state,
        agent_name=record.agent,
        run=record.run,
    )
    return as_told(again, record)


def as_told(again: EpisodeRecord, record: EpisodeRecord) -> EpisodeRecord:
    """A repetition with what a record says beside what happened: nothing of it can be repeated."""
    return replace(again.under(record.circumstances), participation=record.participation)


def resume(record: EpisodeRecord, episode: Episode) -> tuple[Turn, ...]:
    """Bring a fresh episode to where an earlier one of the same run was left.

    Args:
        record: As it was left; its times are taken over.
        episode: Of the same task, agent, run and noise.

    Returns:
        Each call with what came of it, now as then.

    Raises:
        OtherTools: Tools of another version made it.
        NotAsBefore: Something came out otherwise.
    """
    check_tools(record)
    turns = tuple(episode.step(step.call) for step in record.steps)
    if found := differences(record, episode.record):
        raise NotAsBefore(record, found)
    episode.take_times(record.seconds)
    return turns


def differences(first: EpisodeRecord, second: EpisodeRecord) -> list[str]:
    """Where two records differ, timing apart; empty exactly if their bytes are the same."""
    found = [name for name in _FIELDS if getattr(first, name) != getattr(second, name)]
    if len(first.steps) != len(second.steps):
        found.append(f"number of steps: {len(first.steps)} and {len(second.steps)}")
    for number, (a, b) in enumerate(zip(first.steps, second.steps, strict=False), start=1):
        found += [
            f"step {number}: {part}" for part in _PARTS if getattr(a, part) != getattr(b, part)
        ]
    if not found and line_of(first, timed=False) != line_of(second, timed=False):
        found.append("the sign of a zero")
    return found
