"""A recorded episode done again with its motion kept: what a film is cut from."""

from __future__ import annotations

from dataclasses import dataclass

from probe.assets.library import Library
from probe.audit.replaying import unable
from probe.changes.sighting import Look
from probe.episodes.episode import Episode
from probe.episodes.grading import question_of
from probe.episodes.play import perceiver_of, set_table
from probe.episodes.record import EpisodeRecord
from probe.episodes.replay import as_told, check_tools, differences
from probe.episodes.turns import Call, Question
from probe.errors import ProbeError
from probe.film.watched_world import TableMoment, WatchedWorld
from probe.render.renderer import Renderer
from probe.tasks.task import Task
from probe.toolshed.result import ToolResult
from probe.toolshed.skills import SkillOutcome
from probe.types import Array

_SHOWN = 3
"""Differences that a refusal names."""


class CantFilm(ProbeError):
    """An episode that can't be done again, or that comes out otherwise."""

    def __init__(self, record: EpisodeRecord, reason: str) -> None:
        super().__init__(
            f"{record.task}, run {record.run} of {record.agent}, can't be filmed: {reason}. A film "
            "shows what happened or nothing: use the release, the assets and the kind of machine "
            "that the record was made with."
        )


@dataclass(frozen=True, eq=False)
class FilmedCall:
    """A call, what came of it, and when.

    Attributes:
        call: What the agent asked for.
        result: What it read and saw.
        first: Index of the moment at which it began.
        last: Index of the moment at which it was over.
        outcome: What the skill says of it, where it moved the arm.
    """

    call: Call
    result: ToolResult
    first: int
    last: int
    outcome: SkillOutcome | None = None


@dataclass(frozen=True, eq=False)
class Footage:
    """An episode with all of its motion.

    Attributes:
        task: What it is about.
        record: What it was checked against.
        question: What was asked, with the first picture.
        moments: How the table stood, from start to end.
        calls: In order.
        looks: What the tools went by before each call, and after the last one; empty unless asked
            for.
    """

    task: Task
    record: EpisodeRecord
    question: Question
    moments: tuple[TableMoment, ...]
    calls: tuple[FilmedCall, ...]
    looks: tuple[Look, ...] = ()

    @property
    def pictures(self) -> list[Array]:
        """What the agent had seen last before each call, and after the last one; uint8."""
        assert self.question.picture is not None
        seen = [self.question.picture]
        for call in self.calls:
            seen.append(seen[-1] if call.result.picture is None else call.result.picture)
        return seen


def take(
    task: Task,
    record: EpisodeRecord,
    library: Library,
    renderer: Renderer,
    *,
    looking: bool = False,
) -> Footage:
    """Do a record's calls again with pictures, and keep all that moves.

    Args:
        task: What the record is about.
        record: Of a simulated table, by an agent that tools alone told what they saw.
        library: Has the task's objects.
        renderer: Draws what the station sees; what was loaded in it is replaced.
        looking: Whether to keep what the tools saw, too.

    Raises:
        OtherTools: Tools of another version made the record.
        CantFilm: It can't be done again, or not as it was.
    """
    check_tools(record)
    if reason := unable(record):
        raise CantFilm(record, reason)
    world = WatchedWorld(task.scene, library)
    tools, station = set_table(
        task,
        library,
        renderer,
        record.circumstances,
        pictures=True,
        perceiver=perceiver_of(record),
        world=world,
    )
    question = question_of(task, tools.first_picture())
    episode = Episode(
        record.task, question, tools, station, agent_name=record.agent, run=record.run
    )
    calls: list[FilmedCall] = []
    looks = [tools.look] if looking else []
    for step in record.steps:
        first, before = len(world.moments) - 1, tools.outcome
        turn = episode.step(step.call)
        outcome = None if tools.outcome is before else tools.outcome
        calls.append(FilmedCall(turn.call, turn.result, first, len(world.moments) - 1, outcome))
        looks += [tools.look] if looking else []
    if found := differences(record, as_told(episode.record, record)):
        raise CantFilm(record, f"done again, it differs in {', '.join(found[:_SHOWN])}")
    return Footage(task, record, question, tuple(world.moments), tuple(calls), tuple(looks))
