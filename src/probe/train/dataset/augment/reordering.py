"""The same episode with its options under other letters."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from probe.agents.phrases import Say
from probe.episodes.record import EpisodeRecord
from probe.episodes.turns import Call
from probe.tasks.task import LETTERS, Option, Task
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.rephrasing import rephrased


def reordered(
    task: Task, record: EpisodeRecord, rng: np.random.Generator, say: Say
) -> tuple[Task, EpisodeRecord]:
    """A task with its options in another order, and an episode in which it was asked so.

    "None of the above" stays the last one. The scripted teacher must make the same calls, but for
    the letter of its answer.

    Args:
        task: What the episode is about.
        record: What happened.
        rng: Chooses the order.
        say: Chooses the teacher's words.

    Raises:
        NotCertain: The options are the two marked things, no answer was given, or the teacher
            would do something else.
    """
    if len(task.options) != len(LETTERS):
        raise NotCertain(record.task, "its options are the two marked things")
    if record.answer is None or not record.steps:
        raise NotCertain(record.task, "it has no answer")
    order = _other_order(len(LETTERS) - 1, rng)
    texts = [*(task.options[old].text for old in order), task.options[-1].text]
    new = {LETTERS[old]: letter for old, letter in zip(order, LETTERS, strict=False)}
    options = tuple(Option(letter, text) for letter, text in zip(LETTERS, texts, strict=True))
    now = replace(task, options=options, answer=new.get(task.answer, task.answer))
    given = new.get(record.answer.choice, record.answer.choice)
    return now, rephrased(now, _asked_so(record, options, given), say)


def _asked_so(record: EpisodeRecord, options: Sequence[Option], given: str) -> EpisodeRecord:
    """An episode with other options, and another letter for its answer."""
    assert record.answer
    *before, last = record.steps
    call = Call.of(last.call.name, {**last.call.values, "choice": given}, last.call.words)
    return replace(
        record,
        question=replace(record.question, options=tuple((it.letter, it.text) for it in options)),
        steps=(*before, replace(last, call=call)),
        answer=replace(record.answer, choice=given),
    )


def _other_order(count: int, rng: np.random.Generator) -> list[int]:
    """Numbers from 0, of which at least two stand elsewhere."""
    while True:
        order: list[int] = rng.permutation(count).tolist()
        if order != sorted(order):
            return order
