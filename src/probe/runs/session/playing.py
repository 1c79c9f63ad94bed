"""One episode of a session, from its first call to its record."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from probe.agents.external.external_agent import ExternalAgent
from probe.episodes.episode import Episode
from probe.episodes.participation import Participation
from probe.episodes.real import open_real_episode
from probe.episodes.record import EpisodeRecord
from probe.episodes.run import act_out
from probe.episodes.turns import Agent
from probe.errors import ProbeError
from probe.perception.choice import Perceiver
from probe.runs.session.order import Slot
from probe.station.motion_camera import Keep
from probe.station.station import Station
from probe.tasks.task import Task


class StoppedByOperator(ProbeError):
    """Somebody pressed Ctrl-C in the midst of an episode."""

    def __init__(self) -> None:
        super().__init__("the operator stopped it")


def played(
    task: Task,
    slot: Slot,
    agent: Agent,
    station: Station,
    perceiver: Perceiver,
    out: Path,
    film: Callable[[Keep], None] | None = None,
) -> tuple[EpisodeRecord, bool]:
    """Let an agent work at a laid table; whatever else ends the episode is our fault.

    Args:
        task: What is asked.
        slot: Which episode it is.
        agent: Fresh for this episode; its process is ended, if it has one.
        station: The robot, its arm parked.
        perceiver: Makes what the tools see with.
        out: Folder for the pictures.
        film: Is told where pictures of motions go; None if nobody wants any.

    Returns:
        The record, and whether the operator stopped it.

    Raises:
        RobotLost: The robot was lost before the first picture.
    """
    try:
        episode = open_real_episode(task, slot.agent, station, perceiver, out, slot.run, film)
        stopped = _acted(episode, agent)
    finally:
        if isinstance(agent, ExternalAgent):
            agent.close()
    record = episode.record
    if isinstance(agent, ExternalAgent) and agent.fault:
        record = replace(record, participation=Participation("", faults=(agent.fault,)))
    return record, stopped


def _acted(episode: Episode, agent: Agent) -> bool:
    """Act until the end; returns whether the operator stopped it."""
    try:
        act_out(episode, episode.record.question, agent)
    except KeyboardInterrupt:
        episode.fail(StoppedByOperator())
        return True
    except ProbeError as error:
        episode.fail(error)
    return False
