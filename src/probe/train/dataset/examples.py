"""One episode as an example to learn from: the messages that a model saw and should have said.

The one function of chat tells them, for asking and for training.
"""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

from probe.episodes.participation import ModelReply, Points, has_tools
from probe.episodes.record import EpisodeRecord
from probe.errors import BadData
from probe.tasks.suite_file import CANARY
from probe.tasks.task import Task
from probe.toolshed.result import DID_NOTHING
from probe.train.dataset.showing import EpisodePictures
from probe.transcripts.coordinates import told
from probe.transcripts.messages import Message, messages, participation_of
from probe.transcripts.prompts import graphs_of, setting_named, told_with
from probe.transcripts.tools import as_sent


class Canary(BadData):
    """A text of an evaluation suite's file is in an example."""


@dataclass(frozen=True)
class TrainingExample:
    """One conversation.

    Attributes:
        id: Of the task and of who acted in which run.
        question_type, setting: Type of the question, and how it was answered.
        letter: The right answer.
        messages: From the rules to the last reply; nothing follows that.
        tools: What may be called, as servers get it; JSON, empty without tools.
        augmented: How the episode is told otherwise than it went ("mirrored", ...); empty if
            it is told as it went.
        not_learnt: Positions of the messages with a call that did nothing. Nobody should learn to
            say these.
    """

    id: str
    question_type: str
    setting: str
    letter: str
    messages: tuple[Message, ...]
    tools: str
    augmented: str = ""
    not_learnt: frozenset[int] = frozenset()

    @property
    def pictures(self) -> tuple[bytes, ...]:
        """All that are shown, in order."""
        return tuple(
            picture
            for message in self.messages
            for picture in message.pictures
            if isinstance(picture, bytes)
        )


def example_of(
    task: Task,
    record: EpisodeRecord,
    shown: EpisodePictures,
    points: Points | None = None,
    augmented: str = "",
    time: int = 1,
) -> TrainingExample:
    """An episode as an example.

    Args:
        task: What it was about.
        record: What happened.
        shown: Its pictures.
        points: How places are counted; by default as the teacher did.
        augmented: As in TrainingExample; its id ends in it.
        time: How often it has been told so, this time included; a second id ends in 2.

    Raises:
        BadData: The teacher counted places in another way, in which they can't be told.
        Canary: A suite's canary is in a text.
    """
    record = _retold(record, points)
    assert record.participation is not None
    named = record.participation.setting
    setting = setting_named(named)
    told_so = told_with(setting, graphs_of(named))
    conversation = _until_last_reply(messages(record, shown.first, shown.later))
    tools = (
        json.dumps(as_sent(record.participation.points, record.scale, setting))
        if has_tools(setting)
        else ""
    )
    id = f"{task.id}-{record.agent}-{setting}-{record.run}".replace("/", "-")
    made = TrainingExample(
        id="-".join(filter(None, [id, augmented, str(time) if time > 1 else ""])),
        question_type=task.question_type,
        setting=told_so,
        letter=task.answer,
        messages=tuple(conversation),
        tools=tools,
        augmented=augmented,
        not_learnt=_of_no_use(conversation, record),
    )
    _check_canary(made)
    return made


def _retold(record: EpisodeRecord, points: Points | None) -> EpisodeRecord:
    """What the teacher said, told in the way in which a student counts places."""
    seat = participation_of(record)
    if points is None or points == seat.points:
        return replace(record, participation=seat)
    if seat.points != "pixels":
        reason = f"the teacher counted places {seat.points}, and wrote them down so"
        remedy = f"Say --points {seat.points}, or collect with --points {points}"
        raise BadData(record.task, reason, remedy)
    replies = tuple(ModelReply(it.calls, told(it.words, points)) for it in seat.replies)
    steps = tuple(
        replace(step, call=replace(step.call, words=told(step.call.words, points)))
        for step in record.steps
    )
    return replace(record, participation=replace(seat, points=points, replies=replies), steps=steps)


def _until_last_reply(conversation: Sequence[Message]) -> list[Message]:
    """Without what followed the last reply: no model is asked for anything after it."""
    last = max(n for n, message in enumerate(conversation) if message.role == "assistant")
    return list(conversation[: last + 1])


def _of_no_use(conversation: Sequence[Message], record: EpisodeRecord) -> frozenset[int]:
    """Positions of the replies one of whose calls did nothing."""
    calls = {f"call_{n}" for n, it in enumerate(record.steps, 1) if it.status in DID_NOTHING}
    told = enumerate(conversation)
    return frozenset(at for at, said in told if any(id in calls for id, _ in said.calls))


def _check_canary(example: TrainingExample) -> None:
    texts = [message.text for message in example.messages]
    texts += [call.arguments for message in example.messages for _, call in message.calls]
    if any(CANARY in text or CANARY.split()[-1] in text for text in texts):
        remedy = "Leave this episode out: it shows a suite's file"
        raise Canary(example.id, "the canary of the suites is in it", remedy)


def call_arguments(arguments: str) -> dict[str, Any]:
    """A call's arguments as values; messages() gives none that aren't an object."""
    values: dict[str, Any] = json.loads(arguments)
    return values
