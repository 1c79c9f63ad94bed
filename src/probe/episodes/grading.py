"""Between a task and an episode: what is asked of an agent, and what its record is worth."""

from __future__ import annotations

from probe.episodes.record import EpisodeRecord
from probe.episodes.turns import Question
from probe.errors import ProbeError
from probe.tasks.grading import FinalAnswer, LastView, Score, grade, looks_at_end
from probe.tasks.marks import drawn
from probe.tasks.task import LETTERS, Letter, Task
from probe.tasks.type_rules import rules_of
from probe.toolshed.answer_form import AnswerForm
from probe.toolshed.toolshed import MANIPULATIONS
from probe.types import Array


class OtherTask(ProbeError):
    """A record was to be graded by a task that it isn't about."""

    def __init__(self, record: str, task: str) -> None:
        super().__init__(
            f"This episode is about {record!r}, not about {task!r}, or that task has changed "
            "since. Grade it with the suite that it was run on."
        )


class NoPoses(ProbeError):
    """A record of a real table was to be graded by where things lie."""

    def __init__(self, task: str) -> None:
        super().__init__(
            f"{task} asks for a point, or that nothing moves but what is named, and a robot's "
            "record keeps pictures instead of poses: whether that is right can't be told. "
            "Leave such tasks out of a robot's folder."
        )


def question_of(task: Task, picture: Array | None = None) -> Question:
    """What an agent is told of a task: its words and options, and the first picture, marked."""
    if picture is not None:
        picture = drawn(picture, task.marks)
    options = tuple((option.letter, option.text) for option in task.options)
    return Question(task.question, options, picture, task.scale, task.manipulations)


def answer_form(task: Task) -> AnswerForm:
    """What a complete answer to a task is; "None of the above" can't be pointed at."""
    letters = tuple(option.letter for option in task.options)
    pointed = rules_of(task.question_type).pointed
    return AnswerForm(letters, tuple(it for it in letters if it != "E") if pointed else ())


def budget_of(task: Task) -> int:
    """How many grasps and pushes an agent has for a task."""
    return MANIPULATIONS if task.manipulations is None else task.manipulations


def grade_episode(task: Task, record: EpisodeRecord, labels: Array) -> Score:
    """What an episode is worth by its task; needs no physics.

    Args:
        task: What it was about.
        record: What happened.
        labels: Of the table at the record's end, shape (h, w): drawn from its last scene.

    Raises:
        OtherTask: The record is about something else.
        NoPoses: It is of a real table, and its worth depends on where a thing lies.
    """
    if record.frames and needs_labels(task, record):
        raise NoPoses(task.id)
    if record.task != task.id or record.question != question_of(task):
        raise OtherTask(record.task, task.id)
    return grade(task, _answer(record), LastView(labels, record.scenes[-1]))


def needs_labels(task: Task, record: EpisodeRecord) -> bool:
    """Whether labels must be drawn to grade an episode; otherwise any will do, empty ones too."""
    return looks_at_end(task, _answer(record))


def _answer(record: EpisodeRecord) -> FinalAnswer:
    said = record.answer
    return FinalAnswer(_letter(said.choice), said.point_px) if said else FinalAnswer(None)


def _letter(choice: str) -> Letter | None:
    return next((letter for letter in LETTERS if letter == choice), None)
