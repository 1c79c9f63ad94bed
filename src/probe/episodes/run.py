"""Runs one episode: the agent calls, the tools answer, the record grows. Knows no engine."""

from __future__ import annotations

from probe.episodes.episode import Episode, StateReader
from probe.episodes.record import EpisodeRecord
from probe.episodes.turns import Agent, Question, Turn
from probe.toolshed.toolshed import Toolshed


def run_episode(
    task: str,
    question: Question,
    agent: Agent,
    toolshed: Toolshed,
    state: StateReader,
    *,
    agent_name: str,
    run: int = 0,
) -> EpisodeRecord:
    """Let an agent work on a question until it answers, stops, or its turns are over.

    A failure of ours (a ProbeError that a tool raises) ends the episode as "fault" and is
    recorded; it is no answer and mustn't be counted as a wrong one.

    Args:
        task: Name of the task, for the record.
        question: What is asked.
        agent: Sees the question and the tools' results, nothing else.
        toolshed: Fresh, over the table that the witness watches.
        state: Tells the record where things are.
        agent_name: For the record.
        run: Number of the run, for the record.
    """
    episode = Episode(task, question, toolshed, state, agent_name=agent_name, run=run)
    return act_out(episode, question, agent)


def act_out(episode: Episode, question: Question, agent: Agent) -> EpisodeRecord:
    """Let an agent work in a fresh episode; see run_episode."""
    history = list[Turn]()
    while not episode.ended:
        call = agent.act(question, tuple(history))
        if call is None:
            break
        history.append(episode.step(call))
    return episode.record
