"""Other sizes in Size: the teacher's answer is that of the new boxes."""

from __future__ import annotations

import math
import re
from contextlib import suppress
from dataclasses import replace

import numpy as np
import pytest

from probe.agents.reading import read_graph
from probe.train.collect.teacher import speaker
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.resizing import resized

BOX = r"\[(\d+), (\d+)\]"
SIDE_PX = 1024


@pytest.fixture(scope="module")
def of_size(episodes):
    return [it for it in episodes if it[0].question_type == "size" and it[1].answer]


def told(task, record, seed=0):
    return resized(task, record, np.random.default_rng(seed), speaker(task, record.run))


def those_told(episodes, seeds=(0,)):
    """Right ones with what they are with other sizes, where the teacher makes the same calls."""
    for task, record in episodes:
        for seed in seeds:
            with suppress(NotCertain):
                yield (task, record, *told(task, record, seed))


def sizes_of(record):
    """Of A's and B's box, as the teacher compares them; their longer sides may follow."""
    words = record.steps[-1].call.words
    a, b, *longer = ((int(w), int(h)) for w, h in re.findall(BOX, words))
    assert longer in ([], [(max(a), max(b))])
    return [a, b]


def test_the_letter_fits_the_new_sizes(of_size):
    letters = list[tuple[str, str]]()
    for task, _, now, after in those_told(of_size, range(6)):
        a, b = sizes_of(after)
        measure = math.hypot if task.form == "longer" else lambda w, h: w * h
        larger = "A" if measure(*a) > measure(*b) else "B"
        wanted = {"A": "B", "B": "A"}[larger] if task.form == "smaller" else larger
        assert after.answer and after.answer.choice == now.answer == wanted
        assert after.steps[-1].call.values["choice"] == wanted
        letters.append((task.answer, wanted))
    assert len(letters) > 12
    assert len({*letters}) == 4


def test_sizes_differ_clearly_and_are_told_by_the_lists(of_size):
    for _, record, _, after in those_told(of_size):
        a, b = sizes_of(after)
        assert sizes_of(record) != [a, b]
        small, large = sorted((a[0] * a[1], b[0] * b[1]))
        assert large > 1.2 * small
        listed = [seen.size for it in after.steps for seen in read_graph(it.text).objects]
        thousandths = {tuple(round(it * 1000 / SIDE_PX) for it in size) for size in listed}
        assert {a, b} <= thousandths


def test_only_the_boxes_of_the_two_change(of_size):
    numbers = re.compile(r"box: \[[^\]]*\]")
    for _, record, _, after in those_told(of_size):
        changed = set[str]()
        for old, new in zip(record.steps, after.steps, strict=True):
            assert numbers.sub("", old.text) == numbers.sub("", new.text)
            both = zip(read_graph(old.text).objects, read_graph(new.text).objects, strict=True)
            for one, two in both:
                assert 0 <= two.box[0] <= two.box[2] < SIDE_PX
                assert 0 <= two.box[1] <= two.box[3] < SIDE_PX
                changed |= {one.name} if one.box != two.box else set()
        assert changed and len(changed) <= 2


def test_boxes_hold_the_mark_and_what_showed_before(of_size):
    checked = 0
    for task, record, _, after in those_told(of_size, range(3)):
        old, new = (
            [it for step in told.steps for it in read_graph(step.text).objects]
            for told in (record, after)
        )
        parts = [it for it in old if it.name is None]
        for one, two in zip(old, new, strict=True):
            inner = [(*mark.point, *mark.point) for mark in task.marks]
            inner += [(*one.point, *one.point)]
            inner += [it.box for it in parts if it.object_id == one.object_id]
            held = [it for it in inner if holds(one.box, it)]
            assert all(holds(two.box, it) for it in held)
            checked += len(held) if one.box != two.box else 0
    assert checked > 20


def holds(box, inner):
    (left, top, right, bottom), (u, v, s, t) = box, inner
    return left <= u and s <= right and top <= v and t <= bottom


def test_a_wrong_answer_isnt_told_with_other_sizes(of_size):
    task, record, *_ = next(those_told(of_size))
    other = {"A": "B", "B": "A"}[task.answer]
    with pytest.raises(NotCertain, match="its answer wasn't right"):
        told(replace(task, answer=other), record)


def test_where_sizes_arent_asked_for_they_stay(episodes):
    task, record = next(it for it in episodes if it[0].question_type == "compare")
    with pytest.raises(NotCertain, match="its sizes don't matter"):
        told(task, record)
