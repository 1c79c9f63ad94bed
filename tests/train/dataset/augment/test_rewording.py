"""The same question in other words."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from lessons import lesson
from probe.tasks.english import plural
from probe.tasks.suite_file import packaged_suite
from probe.tasks.wordings import wordings
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.rewording import reworded, worded

TASKS = packaged_suite("v1").tasks + packaged_suite("behind").tasks


def silent(task):
    """An episode in which the teacher says nothing."""
    record = lesson(task).record
    steps = tuple(replace(it, call=replace(it.call, words="")) for it in record.steps)
    return replace(record, steps=steps)


def test_every_question_of_a_suite_is_asked_otherwise_with_the_same_in_it():
    rng = np.random.default_rng(0)
    for task in TASKS:
        text = reworded(task, silent(task), rng).question.text
        assert text != task.question and "{" not in text
        marks = task.question.partition(" In the first picture, the marks are ")[1:]
        assert text.partition(" In the first picture, the marks are ")[1:] == marks
        if task.question_type in ("beneath", "behind"):
            assert f"the {task.subject}" in text.lower().replace("The", "the")
        if task.question_type == "count":
            assert str(plural(task.subject)) in text


def test_slots_are_filled_as_the_generator_fills_them():
    """Each wording of a form, filled with a subject that is known, is what a task would ask."""
    count = next(task for task in TASKS if task.question_type == "count")
    names = plural(count.subject)
    ways = {it.text.format(names=names) for it in wordings("count")}
    rng = np.random.default_rng(0)
    found = {reworded(count, silent(count), rng).question.text for _ in range(400)}
    assert found == ways - {count.question} and len(found) >= 19


def test_another_form_is_never_asked():
    rng = np.random.default_rng(0)
    for task in TASKS:
        other = reworded(task, silent(task), rng).question.text
        assert worded(replace(task, question=other), replace_question(task, other))


def replace_question(task, text):
    record = silent(task)
    return replace(record, question=replace(record.question, text=text))


def test_unknown_questions_and_free_words_are_left_alone():
    task = TASKS[0]
    with pytest.raises(NotCertain, match="in no wording"):
        reworded(task, replace_question(task, "What is it?"), np.random.default_rng(0))
    with pytest.raises(NotCertain, match="may have quoted the question"):
        reworded(task, lesson(task).record, np.random.default_rng(0))
