"""Options under other letters: the same is right, by another name, in all that is said."""

from __future__ import annotations

import re
from dataclasses import replace

import numpy as np
import pytest

from painted_teacher import SIZE, taught
from probe.agents.phrases import silent
from probe.tasks.task import NONE_OF_THE_ABOVE
from probe.train.collect.teacher import speaker
from probe.train.dataset.augment.augmenting import augmented
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.listed_ids import SayWithoutFinding
from probe.train.dataset.augment.reordering import reordered
from probe.train.dataset.augment.rephrasing import rephrased
from probe.train.dataset.augment.speech import Speech
from probe.train.dataset.examples import example_of
from probe.train.dataset.text_only import no_pictures

LETTER = re.compile(r"\b([A-E]): ([^?]+)\?")
"""As the teacher goes through the options."""


@pytest.fixture(scope="module")
def episodes(first_batch):
    """Some of the teacher's with five options."""
    return [(task, it) for task, it in first_batch if it.answer and len(it.question.options) == 5]


@pytest.fixture(scope="module")
def marked(first_batch):
    """Some of the teacher's whose options are two marks."""
    return [(task, it) for task, it in first_batch if it.answer and task.marks]


def told(task, record, seed=0):
    return reordered(task, record, np.random.default_rng(seed), speaker(task, record.run))


def letter_of(record):
    assert record.answer
    return record.answer.choice


def text_of(record):
    return dict(record.question.options)[letter_of(record)]


def test_the_same_is_answered_by_another_letter(episodes):
    assert len(episodes) > 5
    moved = 0
    for task, record in episodes:
        now, after = told(task, record)
        assert text_of(after) == text_of(record)
        assert sorted(dict(after.question.options).values()) == sorted(
            text for _, text in record.question.options
        )
        assert after.question.options != record.question.options
        assert after.question.options[-1] == ("E", NONE_OF_THE_ABOVE)
        assert [(it.letter, it.text) for it in now.options] == [*after.question.options]
        assert (now.answer == letter_of(after)) == (task.answer == letter_of(record))
        moved += letter_of(after) != letter_of(record)
    assert moved > len(episodes) / 3


def test_only_the_answer_is_another_call(episodes):
    for task, record in episodes:
        _, after = told(task, record)
        calls = [(step.call.name, step.call.arguments, step.text) for step in after.steps]
        before = [(step.call.name, step.call.arguments, step.text) for step in record.steps]
        assert calls[:-1] == before[:-1]
        assert after.steps[-1].call.values["choice"] == letter_of(after)
        assert {**after.steps[-1].call.values, "choice": ""} == {
            **record.steps[-1].call.values, "choice": "",
        }  # fmt: skip


def test_the_teacher_speaks_of_the_new_letters(episodes):
    spoken = 0
    for task, record in episodes:
        _, after = told(task, record)
        named = LETTER.findall(after.steps[-1].call.words)
        assert set(named) <= set(after.question.options)
        spoken += bool(named)
    assert spoken > len(episodes) / 2


def test_the_order_hangs_on_what_is_drawn_alone(episodes):
    task, record = episodes[0]
    orders = {told(task, record, seed)[1].question.options for seed in range(8)}
    assert len(orders) > 3
    assert told(task, record, 3) == told(task, record, 3)


@pytest.mark.parametrize("find", [True, False])
def test_an_example_has_the_new_letter(episodes, find):
    said = [
        (task, rephrased(task, record, SayWithoutFinding(speaker(task, record.run))))
        for task, record in episodes
    ]
    again = augmented(said if not find else episodes, ["options"], 0, Speech(find))
    assert len(again.episodes) == len(episodes)
    calls = [step.call.name for _, _, record in again.episodes for step in record.steps]
    assert ("find_object" in calls) is find
    for (way, task, record), (before, _) in zip(again.episodes, episodes, strict=True):
        made = example_of(task, record, no_pictures(record), None, way)
        assert (
            dict(record.question.options)[made.letter]
            == dict((it.letter, it.text) for it in before.options)[before.answer]
        )


@pytest.mark.parametrize("find", [True, False])
def test_marks_have_each_others_letters(find):
    """The marks' places tell what is meant: each is called by the other letter throughout."""
    before = taught()
    if not find:
        before = rephrased(SIZE, before, SayWithoutFinding(speaker(SIZE, 0)))
    say = speaker(SIZE, 0) if find else SayWithoutFinding(speaker(SIZE, 0))
    now, after = reordered(SIZE, before, np.random.default_rng(0), say)
    a, b = (mark.point for mark in SIZE.marks)
    assert f"A at ({b[0]}, {b[1]}) and B at ({a[0]}, {a[1]})" in after.question.text
    assert after.question.text == now.question
    assert after.question.options == before.question.options
    assert {letter_of(before), letter_of(after)} == {"A", "B"}
    assert (now.answer == letter_of(after)) == (SIZE.answer == letter_of(before))
    assert [it.text for it in after.steps] == [it.text for it in before.steps]
    swapped = str.maketrans("AB", "BA")
    spoken = ""
    for old, new in zip(before.steps[:-1], after.steps[:-1], strict=True):
        letters = [re.findall(r"[Mm]ark(?:ed)? ([AB])\b", it.call.words) for it in (old, new)]
        assert "".join(letters[0]).translate(swapped) == "".join(letters[1])
        spoken += "".join(letters[0])
        assert (old.call.name, old.call.arguments) == (new.call.name, new.call.arguments)
    assert spoken


def test_an_answer_says_the_same_of_each_mark_by_its_new_letter():
    before = taught()
    _, after = reordered(SIZE, before, np.random.default_rng(0), speaker(SIZE, 0))
    boxes = r"A is the (.*?),.*?(\[\d+, \d+\]).*B.*? the (.*?),.*?(\[\d+, \d+\])"
    found = [re.search(boxes, it.steps[-1].call.words) for it in (before, after)]
    assert found[0] and found[1]
    one, two = (it.groups() for it in found if it)
    assert one == (*two[2:], *two[:2]) and one[:2] != two[:2]


def test_colours_stay_with_the_things_that_have_them(marked):
    colours = (
        r"(?:The|A, the) (.*?),? is (\w+),? and (?:B, )?the (.*?)(?: is|,) (\w+)(?:, so|:) "
        r"(\w+) is A; (\w+) is B\b"
    )
    told = 0
    for task, record in marked:
        _, after = reordered(task, record, np.random.default_rng(0), speaker(task, record.run))
        found = [re.search(colours, it.steps[-1].call.words) for it in (record, after)]
        if task.question_type != "compare" or not all(found):
            continue
        one, two = (it.groups() for it in found if it)
        assert one[:4] == (*two[2:4], *two[:2])
        assert one[4:] == (one[1], one[3]) and two[4:] == (two[1], two[3])
        told += 1
    assert told > 1


def test_the_longer_side_is_still_that_of_the_larger_one(marked):
    sides = r"\[(\d+), (\d+)\]: the (?:larger|longer) one is ([AB]); the \w+ one is ([AB])\."
    told = 0
    for task, record in marked:
        _, after = reordered(task, record, np.random.default_rng(0), speaker(task, record.run))
        for a, b, more, less in re.findall(sides, after.steps[-1].call.words):
            assert (more, less) == (("A", "B") if int(a) > int(b) else ("B", "A"))
            told += 1
    assert told > 1


def test_what_isnt_sure_is_left_out(episodes):
    task, record = episodes[0]
    with pytest.raises(NotCertain, match="it has no answer"):
        told(task, replace(record, answer=None))
    with pytest.raises(NotCertain, match="isn't the scripted one"):
        told(task, replace(record, agent="a-model"))
    longer = replace(record, steps=(record.steps[0], *record.steps))
    with pytest.raises(NotCertain, match="would do something else today"):
        told(task, longer)
    _, after = reordered(task, record, np.random.default_rng(0), silent)
    assert {step.call.words for step in after.steps} == {""}
