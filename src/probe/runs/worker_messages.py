"""What is said over the pipe between a model's side and the process that has its table."""

from __future__ import annotations

from dataclasses import dataclass

from probe.episodes.participation import Participation
from probe.episodes.turns import Call
from probe.runs.plan import Job
from probe.tasks.grading import Score
from probe.toolshed.result import Answer


@dataclass(frozen=True)
class StartEpisode:
    """Set the table of a job; the reply is Shown."""

    job: Job


@dataclass(frozen=True)
class FinishEpisode:
    """The model is done; the reply is Left.

    Attributes:
        participation: Its part in it.
        answer: What it said, if it had no tools to say it with.
        fault: What failed on our side, if that is why.
    """

    participation: Participation
    answer: Answer | None = None
    fault: str | None = None


@dataclass(frozen=True)
class GradeRecord:
    """Say what a record is worth that was made before; the reply is Left.

    Attributes:
        job: What it was about.
        line: The record, as it is written down.
    """

    job: Job
    line: bytes


Request = StartEpisode | Call | FinishEpisode | GradeRecord


@dataclass(frozen=True)
class EpisodeStarted:
    """Pictures that come with the question, as JPEG files."""

    pictures: tuple[bytes, ...]


@dataclass(frozen=True)
class CallResult:
    """What came of a call."""

    text: str
    picture: bytes | None
    ended: bool


@dataclass(frozen=True)
class EpisodeFinished:
    """A record as a line, and what it is worth; None if it is missing."""

    line: bytes
    score: Score | None


@dataclass(frozen=True)
class EpisodeFailed:
    """The table couldn't be set, or a call failed on our side; the table is gone."""

    reason: str


Response = EpisodeStarted | CallResult | EpisodeFinished | EpisodeFailed


@dataclass(frozen=True)
class PointerRequest:
    """What perception has to ask a model: pictures as JPEG files, and words."""

    pictures: tuple[bytes, ...]
    text: str


@dataclass(frozen=True)
class NoReply:
    """No reply came; any other answer to Asked is the reply itself."""

    reason: str
