"""Another wording of an episode's question, with the same slots."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from probe.episodes.record import EpisodeRecord
from probe.generation.task_writer import asked
from probe.tasks.task import Task
from probe.tasks.wordings import Wording, wordings
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.slots import pattern_of
from probe.train.dataset.augment.teacher_words import are_the_teachers
from probe.transcripts.messages import participation_of


@dataclass(frozen=True)
class WordedQuestion:
    """How a task is asked.

    Attributes:
        wording: One of its type's.
        slots: What fills its slots.
    """

    wording: Wording
    slots: Mapping[str, str]


def worded(task: Task, record: EpisodeRecord) -> WordedQuestion:
    """How the question of an episode is asked.

    Raises:
        NotCertain: None of its type's wordings, or several, give this question.
    """
    ways = [it for it in wordings(task.question_type) if it.form == task.form]
    found = [
        WordedQuestion(wording, slots)
        for wording in ways
        for slots in _slots(wording.text, task)
        if asked(wording.text, slots, task.marks) == record.question.text
    ]
    if len(found) != 1:
        raise NotCertain(record.task, "its question is in no wording of today, or in several")
    return found[0]


def reworded(task: Task, record: EpisodeRecord, rng: np.random.Generator) -> EpisodeRecord:
    """An episode in which the same is asked in other words.

    Args:
        task: What it is about.
        record: What happened; all but its question stays.
        rng: Chooses among the wordings.

    Raises:
        NotCertain: The question can't be asked otherwise, or the teacher may have quoted it.
    """
    known = worded(task, record)
    seat = participation_of(record)
    said = [step.call.words for step in record.steps] + [reply.words for reply in seat.replies]
    if not all(map(are_the_teachers, said)):
        raise NotCertain(record.task, "its teacher spoke freely, and may have quoted the question")
    others = [
        it.text
        for it in wordings(task.question_type)
        if it.form == task.form and it != known.wording
    ]
    if not others:
        raise NotCertain(record.task, "its question has one wording")
    text = asked(others[int(rng.integers(len(others)))], known.slots, task.marks)
    return replace(record, question=replace(record.question, text=text))


def _slots(wording: str, task: Task) -> list[dict[str, str]]:
    """What may fill a wording's slots, if the task's question begins with it."""
    marks = asked("", {}, task.marks)
    found = re.fullmatch(pattern_of(wording) + re.escape(marks), task.question)
    return [found.groupdict()] if found else []
