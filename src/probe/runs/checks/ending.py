"""Whether a record's answer is what was said, and its end what its steps and answer make it."""

from __future__ import annotations

import math
from collections.abc import Iterator

from probe.episodes.participation import Participation, has_tools
from probe.episodes.record import EpisodeRecord
from probe.runs.checks.calls import request_of
from probe.toolshed.result import Answer
from probe.toolshed.tools import AnswerQuestion
from probe.toolshed.toolshed import TURNS
from probe.transcripts.answers import read_answer

_REPLIES = 2
"""Of a model without tools: its answer, and one after it was reminded."""

_ROUNDED_PX = 1.0
"""A place that is told in thousandths of the picture is rounded to a whole one."""


def amiss_at_the_end(record: EpisodeRecord) -> Iterator[str]:
    """In what answer, end, fault and the calls or replies of a record don't agree."""
    yield from _of_end(record)
    if record.participation is not None and not has_tools(record.participation.setting):
        yield from _in_words(record, record.participation)
    else:
        yield from _with_tools(record)


def _of_end(record: EpisodeRecord) -> Iterator[str]:
    if (record.answer is None) == (record.end == "answered"):
        has = "an" if record.answer else "no"
        yield f'it has {has} answer, and its end is "{record.end}"'
    if (record.end == "fault") != bool(record.fault):
        has = "tells of a fault" if record.fault else "tells of none"
        yield f'it {has}, and its end is "{record.end}"'


def _with_tools(record: EpisodeRecord) -> Iterator[str]:
    side_px = record.viewpoint.camera.width_px
    requests = [request_of(step, side_px) for step in record.steps]
    answers = [
        Answer(request.choice, request.point)
        if isinstance(request, AnswerQuestion) and step.status == "done"
        else None
        for request, step in zip(requests, record.steps, strict=True)
    ]
    if any(answers[:-1]):
        yield "calls follow its answer"
    said = answers[-1] if answers else None
    if record.answer != said:
        yield f"its answer is {_words(record.answer)}, and its last call says {_words(said)}"
    turns = len(record.steps)
    spent = turns >= TURNS and record.answer is None
    if record.end in ("stopped", "out_of_turns") and spent != (record.end == "out_of_turns"):
        yield f'its end is "{record.end}" after {turns} of {TURNS} turns'
    if record.participation is not None:
        called = sum(reply.calls for reply in record.participation.replies)
        # A reply that a failure broke off isn't among them; its first calls may be.
        whole = record.end in ("answered", "out_of_turns")
        if called > turns or (whole and called < turns):
            yield f"its model's replies made {called} calls, and it has {turns}"


def _in_words(record: EpisodeRecord, seat: Participation) -> Iterator[str]:
    if record.steps:
        yield f"it has calls, and nobody has tools in the setting {seat.setting!r}"
    if len(seat.replies) > _REPLIES or any(reply.calls for reply in seat.replies):
        most = f"{_REPLIES} replies at most"
        yield f"in the setting {seat.setting!r} a model makes {most}, and no calls"
    letters = "".join(letter for letter, _ in record.question.options)
    read = [read_answer(reply.words, seat.points, letters) for reply in seat.replies]
    said = next((answer for answer in reversed(read) if answer), None)
    if record.answer is not None and not _alike(record.answer, said):
        yield f"its answer is {_words(record.answer)}, and its replies say {_words(said)}"


def _alike(answer: Answer, said: Answer | None) -> bool:
    if said is None or answer.choice != said.choice:
        return False
    if answer.point_px is None or said.point_px is None:
        return answer.point_px == said.point_px
    return math.dist(answer.point_px, said.point_px) <= _ROUNDED_PX


def _words(answer: Answer | None) -> str:
    if answer is None:
        return "none"
    place = "" if answer.point_px is None else " at ({:g}, {:g})".format(*answer.point_px)
    return ascii(answer.choice[:8]) + place
