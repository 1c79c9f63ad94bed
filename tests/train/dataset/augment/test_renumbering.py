"""Other object_ids: each is the same other one everywhere, and nothing else changes."""

from __future__ import annotations

import re

import numpy as np
import pytest

from packed_teacher import said_in
from painted_teacher import SIZE, taught
from probe.train.collect.teacher import speaker
from probe.train.dataset.augment.augmenting import augmented
from probe.train.dataset.augment.listed_ids import SayWithoutFinding
from probe.train.dataset.augment.renumbering import renumbered
from probe.train.dataset.augment.rephrasing import rephrased
from probe.train.dataset.augment.speech import Speech

ID = re.compile(r"\bobject_\d+\b")


def renumbering(task, record, seed=0):
    return renumbered(task, record, np.random.default_rng(seed), speaker(task, record.run))


@pytest.mark.parametrize("seed", [0, 1])
def test_every_object_id_is_changed_the_same_way_everywhere(episodes, seed):
    for task, record in episodes:
        now, after = renumbering(task, record, seed)
        assert now == task
        for old, new in zip(record.steps, after.steps, strict=True):
            assert ID.sub("object", old.text) == ID.sub("object", new.text)
            assert ID.sub("object", old.call.arguments) == ID.sub("object", new.call.arguments)
        texts = [
            "\n".join(f"{step.call.arguments}\n{step.text}" for step in it.steps)
            for it in (record, after)
        ]
        pairs = {*zip(*(ID.findall(text) for text in texts), strict=True)}
        assert len(dict(pairs)) == len(pairs) == len({new for _, new in pairs})
        assert {*ID.findall(said_in(after))} <= {new for _, new in pairs}


def test_they_have_no_order(episodes):
    for task, record in episodes:
        _, after = renumbering(task, record)
        first = next(it.text for it in after.steps if it.call.name == "perceive_scene")
        numbers = [int(it) for it in re.findall(r"object_id: object_(\d+)", first)]
        assert numbers != sorted(numbers) and len({*numbers}) == len(numbers) > 5


def test_the_draw_alone_decides(episodes):
    task, record = episodes[0]
    told = [renumbering(task, record, seed)[1] for seed in (1, 1, 2)]
    assert told[0] == told[1] != told[2]


@pytest.mark.parametrize("find", [True, False])
def test_they_are_ways_to_tell_a_selection_again(find):
    record = taught()
    if not find:
        record = rephrased(SIZE, record, SayWithoutFinding(speaker(SIZE, 0)))
    again = augmented([(SIZE, record)], ["ids", "names"], 0, Speech(find))
    assert [way for way, _, _ in again.episodes] == ["ids"]
    assert again.left_out == {"ids": {}, "names": {"there are too few other names": 1}}
    calls = {step.call.name for step in again.episodes[0][2].steps}
    assert ("find_object" in calls) is find
