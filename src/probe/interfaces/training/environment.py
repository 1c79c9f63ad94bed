"""The environment that trainers let a model act in: five tools, and a reward at the end."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from functools import wraps
from typing import Concatenate, ParamSpec, TypeVar

from probe.bench.process_pool import EpisodeProcessLost
from probe.episodes.files import line_of, record_of
from probe.episodes.participation import ModelReply, Participation, Points
from probe.episodes.record import EpisodeRecord
from probe.episodes.turns import Call
from probe.errors import BadData, ProbeError
from probe.interfaces.training.seat import Seat
from probe.interfaces.training.tables import TrainingTables
from probe.runs.work import failed
from probe.runs.worker_messages import EpisodeFinished, FinishEpisode
from probe.tasks.task import Letter
from probe.toolshed.refusals import EpisodeOver
from probe.toolshed.skills import Direction
from probe.transcripts.coordinates import meant
from probe.transcripts.result_texts import ResultTexts

Said = ParamSpec("Said")
Env = TypeVar("Env", bound="ProbeEnv")


class NoEpisode(ProbeError):
    """A tool was called, or a reward asked for, before the first reset."""

    def __init__(self) -> None:
        super().__init__("No episode has begun. Call reset(task=...) first.")


def as_tool(described: Callable[Concatenate[Env, Said], str]) -> Callable[..., str]:
    """A method that sends what it is called with to the tool of its name, whether or not it fits.

    Malformed calls then cost a turn and are told off in the tool's words, as in an evaluation.
    """
    names = list(inspect.signature(described).parameters)[1:]

    @wraps(described)
    def called(env: Env, /, *values: object, **named: object) -> str:
        given = dict(zip(names, values, strict=False)) | named
        return env(described.__name__, given).text

    return called


@dataclass(frozen=True)
class Told:
    """What a model is told after a call.

    Attributes:
        text: The reply.
        ended: Whether the episode is over.
    """

    text: str
    ended: bool


class ProbeEnv:
    """One place at a table, for episode after episode, in the form that TRL's trainers take.

    Pass `functools.partial(ProbeEnv, tables)` as `environment_factory`. Its tools are its only
    public methods besides `reset` and `get_reward`. They reply as in the setting "text-only", with
    places in pixels; ProbeEnvThousandths has them in thousandths.

    Args:
        tables: See probe.training_tables.

    Raises:
        BadData: The tables count places otherwise.
    """

    _points: Points = "pixels"

    def __init__(self, tables: TrainingTables) -> None:
        if tables.order.points != self._points:
            reason = f"count places in {tables.order.points}, and {type(self).__name__} doesn't"
            remedy = 'ProbeEnv is for points="pixels", ProbeEnvThousandths for points="0-1000"'
            raise BadData("tables", reason, remedy)
        self._tables = tables
        self._seat: Seat | None = None
        self._texts = ResultTexts(self._points)
        self._calls, self._ended = 0, False
        self._lost: EpisodeProcessLost | None = None
        self._left: EpisodeFinished | None = None

    @property
    def record(self) -> EpisodeRecord | None:
        """Of the episode whose reward was asked for last."""
        return record_of(self._left.line) if self._left else None

    def reset(self, **row: object) -> None:
        """Begin an episode; the table is set while the trainer goes on.

        Args:
            row: Of `tables.rows()`; "task" names the task, and its "prompt" is all that a model
                is told first, so that nothing is added to it.

        Raises:
            UnknownName: There is no such task.
            TooFewTables: All tables are taken.
        """
        self._give_back()
        self._left, self._lost, self._calls, self._ended = None, None, 0, False
        self._texts = ResultTexts(self._points, self._tables.graphs)
        self._seat = self._tables.seat(str(row.get("task")))

    @as_tool
    def perceive_scene(self) -> str:
        """List the objects that the camera sees now, each with its object_id and a point on it.

        What is hidden by others is in no list.
        """
        ...

    @as_tool
    def find_object(self, description: str) -> str:
        """Get object_id, description and box of one object that shows.

        Args:
            description: What it looks like ("red mug"), or where it is: "(u, v)" in pixels.
        """
        ...

    @as_tool
    def grasp_and_remove(self, object_id: str) -> str:
        """Drop an object into the basket, for good. It can fail, and neighbours may move.

        Args:
            object_id: Such as "object_1".
        """
        ...

    @as_tool
    def push(self, object_id: str, direction: Direction, distance_cm: float) -> str:
        """Push an object over the table, with what stands ahead of it.

        Args:
            object_id: Such as "object_1".
            direction: As the camera sees it.
            distance_cm: 3 to 20. The picture is 58 cm wide.
        """
        ...

    @as_tool
    def answer_question(self, choice: Letter, point: list[float] | None = None) -> str:
        """Give the final answer, once.

        Args:
            choice: Letter of an option.
            point: Only if you are asked to point: [u, v] in pixels on that object.
        """
        ...

    def get_reward(self) -> float | None:
        """1 for a right answer by the task's grading, 0 for another or none.

        It ends the episode; asked again, it says the same.

        Returns:
            The reward; None if the episode was lost through no fault of the model: TRL leaves such
            rollouts out.

        Raises:
            NoEpisode: None has begun.
        """
        if self._left is None:
            self._left = self._finished()
        score = self._left.score
        return None if score is None else float(score.correct)

    def __call__(self, tool: str, arguments: Mapping[str, object]) -> Told:
        """Call a tool by its name, as callers do that have calls as data.

        Raises:
            NoEpisode: None has begun.
            EpisodeProcessLost: The episode is lost; its reward is None.
        """
        if self._seat is None:
            if self._left is None:
                raise NoEpisode
            return Told(str(EpisodeOver()), ended=True)
        if self._lost:
            raise self._lost
        if self._ended:
            return Told(str(EpisodeOver()), ended=True)
        try:
            came = self._seat.call(meant(Call.of(tool, arguments), self._points))
        except EpisodeProcessLost as error:
            self._lost = error
            raise
        self._calls, self._ended = self._calls + 1, came.ended
        return Told(self._texts.told(tool, came.text), came.ended)

    def __enter__(self) -> ProbeEnv:
        """Itself."""
        return self

    def __exit__(self, *_: object) -> None:
        """Leave the table; an episode whose reward nobody asked for leaves no record."""
        self._give_back()

    def _finished(self) -> EpisodeFinished:
        """The record of what was played, graded; the table is given back."""
        if self._seat is None:
            raise NoEpisode
        seat, order = self._seat, self._tables.order
        replies = tuple(ModelReply(1) for _ in range(self._calls))
        part = Participation(order.setting, order.points, replies)
        try:
            if self._lost:
                raise self._lost
            left = seat.finish(FinishEpisode(replace(part, faults=seat.failures)))
        except EpisodeProcessLost as error:
            record = failed(seat.job, order, str(error))
            record = replace(record, participation=replace(part, replies=()))
            left = EpisodeFinished(line_of(record), None)
        self._give_back(left.line)
        return left

    def _give_back(self, line: bytes | None = None) -> None:
        if self._seat is not None:
            self._tables.give_back(self._seat, line)
            self._seat = None
