"""A record as the messages that a model saw, in the order in which its server got them.

Pictures of tool results follow in a message of the user's, after all results of a reply: OpenAI's
protocol allows no pictures in results. Knows no server.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Literal

from probe.episodes.participation import ModelReply, Participation, Points
from probe.episodes.record import EpisodeRecord, Step
from probe.episodes.turns import Call, Question
from probe.errors import ProbeError
from probe.toolshed.toolshed import MANIPULATIONS
from probe.transcripts.answers import read_answer
from probe.transcripts.coordinates import as_said, told
from probe.transcripts.prompts import Setting, graphs_of, reminder, setting_named, system_prompt
from probe.transcripts.result_texts import ResultTexts
from probe.types import USUAL_SCALE, Array, PictureScale

Picture = Array | bytes
"""Pixels, uint8 (h, w, 3), or an encoded file: whatever the caller has; it is passed on."""

PICTURE_FOLLOWS = "Image content is included below."
"""Ends a tool result whose picture follows in a message of its own."""


class OtherPictures(ProbeError):
    """The pictures aren't those of the record."""

    def __init__(self, task: str, wanted: int, given: int) -> None:
        super().__init__(
            f"{task}: its messages take {wanted} pictures (None where a result has none), not "
            f"{given}. Play the record again to get them."
        )


@dataclass(frozen=True, eq=False)
class Message:
    """One message.

    Attributes:
        role: Whose it is.
        text: Its words.
        pictures: What it shows, after its words.
        calls: Tools that a reply called; their ids are call_1, call_2, ...
        call_id: Which call a tool's result answers.
    """

    role: Literal["system", "user", "assistant", "tool"]
    text: str
    pictures: tuple[Picture, ...] = ()
    calls: tuple[tuple[str, Call], ...] = ()
    call_id: str = ""


def opening(
    setting: Setting,
    points: Points,
    question: Question,
    pictures: Sequence[Picture],
    scale: PictureScale = USUAL_SCALE,
) -> tuple[Message, Message]:
    """What a model gets first: the rules, then the question with its pictures."""
    lines = [question.text, *(f"{letter}: {text}" for letter, text in question.options)]
    asked = told("\n".join(lines), points)
    allowed = MANIPULATIONS if question.manipulations is None else question.manipulations
    rules = system_prompt(setting, points, scale, allowed)
    return Message("system", rules), Message("user", asked, tuple(pictures))


def messages(
    record: EpisodeRecord,
    first: Sequence[Picture],
    later: Sequence[Picture | None] = (),
) -> list[Message]:
    """All messages of an episode, the model's own included; the last ones may have no reply.

    Args:
        record: What happened.
        first: Pictures that came with the question: one; none in the settings "blind" and
            "text-only"; two in "oracle-view".
        later: Of each step, the picture that its result came with; None where there was none.

    Raises:
        OtherPictures: There are more or fewer.
    """
    seat = participation_of(record)
    if len(later) != len(record.steps):
        raise OtherPictures(record.task, len(record.steps), len(later))
    setting = setting_named(seat.setting)
    told_first = opening(setting, seat.points, record.question, first, record.scale)
    return [*told_first, *_conversation(record, seat, setting, later)]


def participation_of(record: EpisodeRecord) -> Participation:
    """How an agent took part; without a model with tools, one call a reply, places in pixels."""
    replies = tuple(ModelReply(1) for _ in record.steps)
    return record.participation or Participation("agentic", replies=replies)


def _conversation(
    record: EpisodeRecord, seat: Participation, setting: Setting, later: Sequence[Picture | None]
) -> Iterator[Message]:
    at, texts = 0, ResultTexts(seat.points, graphs_of(seat.setting))
    for number, reply in enumerate(seat.replies, start=1):
        if reply.calls == 0:
            yield Message("assistant", reply.words)
            if number < len(seat.replies):
                yield Message("user", reminder(setting, answered=_answered(reply, record, seat)))
            continue
        steps = list(enumerate(record.steps[at : at + reply.calls], start=at + 1))
        calls = tuple((f"call_{n}", _as_sent(step.call, seat.points)) for n, step in steps)
        yield Message("assistant", steps[0][1].call.words, calls=calls)
        yield from _results(steps, [later[n - 1] for n, _ in steps], texts)
        at += reply.calls


def _answered(reply: ModelReply, record: EpisodeRecord, seat: Participation) -> bool:
    """Whether a reply in words gives a letter; one that is reminded all the same lacks a point."""
    letters = "".join(letter for letter, _ in record.question.options)
    return read_answer(reply.words, seat.points, letters) is not None


def _results(
    steps: Sequence[tuple[int, Step]], pictures: Sequence[Picture | None], texts: ResultTexts
) -> Iterator[Message]:
    """What came of a reply's calls; results without a picture come first."""
    shown: list[Picture] = []
    read = [texts.told(step.call.name, step.text) for _, step in steps]
    for index in pictureless_first(pictures):
        (number, _), picture, text = steps[index], pictures[index], read[index]
        if picture is not None:
            shown.append(picture)
            text = f"{text}\n{PICTURE_FOLLOWS}"
        yield Message("tool", text, call_id=f"call_{number}")
    if shown:
        yield Message("user", "", tuple(shown))


def pictureless_first(pictures: Sequence[object | None]) -> list[int]:
    """Order in which the results of one reply are told.

    Between two results there must be no message of the user's, and one that shows pictures would
    follow each result that has some.
    """
    return sorted(range(len(pictures)), key=lambda index: pictures[index] is not None)


def _as_sent(call: Call, points: Points) -> Call:
    """As it stands in the conversation: arguments that weren't an object are left out there."""
    said = as_said(call, points)
    return said if isinstance(said.values, dict) else Call(said.name, "{}", said.words)
