"""The same episode with its options, or its two marks, under other letters."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from probe.agents.phrases import Say
from probe.episodes.record import EpisodeRecord
from probe.generation.task_writer import asked
from probe.tasks.task import LETTERS, Mark, Option, Task
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.rephrasing import rephrased
from probe.train.dataset.augment.retelling import answered
from probe.train.dataset.augment.rewording import worded

_PAIRS = tuple((f"{what}one", f"{what}two") for what in ("", "size_", "long_", "colour_"))
_OTHER = {a: b for pair in _PAIRS for a, b in (pair, pair[::-1])}
"""Slots of phrases that tell of mark A, and what tells the same of mark B."""


def reordered(
    task: Task, record: EpisodeRecord, rng: np.random.Generator, say: Say
) -> tuple[Task, EpisodeRecord]:
    """A task with its options in another order, and an episode in which it was asked so.

    "None of the above" stays the last one, and the scripted teacher, asked again, must make the
    same calls but for the letter of its answer. Where the options are the two marked things, mark
    A becomes mark B: what was done for A first is now done for B first.

    Args:
        task: What the episode is about.
        record: What happened.
        rng: Chooses the order.
        say: Chooses the teacher's words.

    Raises:
        NotCertain: No answer was given, the teacher would do something else, or the question with
            the marks is in no wording of today, or in several.
    """
    if record.answer is None or not record.steps:
        raise NotCertain(record.task, "it has no answer")
    if task.marks:
        return _swapped(task, record, say)
    order = _other_order(len(LETTERS) - 1, rng)
    texts = [*(task.options[old].text for old in order), task.options[-1].text]
    new = {LETTERS[old]: letter for old, letter in zip(order, LETTERS, strict=False)}
    options = tuple(Option(letter, text) for letter, text in zip(LETTERS, texts, strict=True))
    now = replace(task, options=options, answer=new.get(task.answer, task.answer))
    given = new.get(record.answer.choice, record.answer.choice)
    return now, rephrased(now, _asked_so(record, options, given), say)


def _swapped(task: Task, record: EpisodeRecord, say: Say) -> tuple[Task, EpisodeRecord]:
    """A task whose marks have each other's letters, and an episode that begins with mark B."""
    assert record.answer
    a, b = (mark.letter for mark in task.marks)
    new = {a: b, b: a}
    marks = tuple(
        replace(mark, letter=new[mark.letter])
        for mark in sorted(task.marks, key=_letter, reverse=True)
    )
    known = worded(task, record)
    text = asked(known.wording.text, known.slots, marks)
    told = rephrased(task, record, _SayOfTheOther(say))
    now = replace(task, marks=marks, question=text, answer=new[task.answer])
    told = answered(told, new[record.answer.choice])
    return now, replace(told, question=replace(told.question, text=text))


def _letter(mark: Mark) -> str:
    return mark.letter


@dataclass(frozen=True)
class _SayOfTheOther:
    """Says of mark B what is true of mark A, and the other way round; a Say."""

    say: Say

    def __call__(self, occasion: str, slots: Mapping[str, str]) -> str:
        other = {slot: slots[_OTHER.get(slot, slot)] for slot in slots}
        for slot, letter in slots.items():
            if slot.startswith("letter"):
                other[slot] = {"A": "B", "B": "A"}.get(letter, letter)
        return self.say(occasion, other)


def _asked_so(record: EpisodeRecord, options: Sequence[Option], given: str) -> EpisodeRecord:
    """An episode with other options, and another letter for its answer."""
    question = replace(record.question, options=tuple((it.letter, it.text) for it in options))
    return replace(answered(record, given), question=question)


def _other_order(count: int, rng: np.random.Generator) -> list[int]:
    """Numbers from 0, of which at least two stand elsewhere."""
    while True:
        order: list[int] = rng.permutation(count).tolist()
        if order != sorted(order):
            return order
