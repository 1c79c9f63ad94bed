"""The same episode with other phrases of the scripted teacher."""

from __future__ import annotations

from dataclasses import replace

from probe.agents.phrases import Say
from probe.episodes.record import EpisodeRecord, Step
from probe.episodes.turns import Turn
from probe.tasks.task import Task
from probe.toolshed.result import ToolResult
from probe.train.collect.teacher import TEACHER, teacher
from probe.train.dataset.augment.certain import NotCertain
from probe.transcripts.messages import participation_of


def check_teacher(record: EpisodeRecord) -> None:
    """See that the scripted teacher taught.

    Raises:
        NotCertain: Somebody else did.
    """
    if record.agent != TEACHER:
        raise NotCertain(record.task, "its teacher isn't the scripted one")


def rephrased(task: Task, record: EpisodeRecord, say: Say | None = None) -> EpisodeRecord:
    """An episode in which the teacher does the same and says it otherwise.

    It reads the replies that the record has, and must make the same calls.

    Args:
        task: What it is about.
        record: What happened; all but the teacher's words stays.
        say: Chooses the words; by default as when the teacher plays.

    Raises:
        NotCertain: Somebody else taught, or today's teacher would have done something else.
    """
    check_teacher(record)
    agent = teacher(task, record.run, participation_of(record).points, say)
    history, steps = list[Turn](), list[Step]()
    for step in record.steps:
        call = agent.act(record.question, history)
        if call is None or replace(call, words=step.call.words) != step.call:
            raise NotCertain(record.task, "its teacher would do something else today")
        history.append(Turn(call, ToolResult(step.text)))
        steps.append(replace(step, call=call))
    return replace(record, steps=tuple(steps))
