"""Fewer things: lists lack some that nobody speaks of, and all else is as it was."""

from __future__ import annotations

import re
from contextlib import suppress

import numpy as np
import pytest

from packed_teacher import names_in
from painted_teacher import SIZE, taught
from probe.agents.reading import read_graph
from probe.train.collect.teacher import speaker
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.thinning import thinned


def told(task, record, seed=0):
    return thinned(task, record, np.random.default_rng(seed), speaker(task, record.run))[1]


@pytest.fixture(scope="module")
def thin(episodes):
    found = []
    for task, record in episodes:
        with suppress(NotCertain):
            found.append((record, told(task, record)))
    assert len(found) > len(episodes) / 2
    return found


def lists(record):
    return [step.text for step in record.steps if step.call.name == "perceive_scene"]


def test_lists_lack_the_same_things_throughout(thin):
    shares = list[float]()
    for before, after in thin:
        gone = {name for names in names_in(before) for name in names}
        gone -= {name for names in names_in(after) for name in names}
        assert gone and None not in gone
        for old, new in zip(names_in(before), names_in(after), strict=True):
            assert new == [name for name in old if name not in gone]
        shares.append(len(names_in(after)[0]) / len(names_in(before)[0]))
    assert sum(shares) / len(shares) < 0.8


def test_what_stays_has_its_entry_and_its_relations(thin):
    for before, after in thin:
        for old, new in zip(lists(before), lists(after), strict=True):
            one, two = read_graph(old), read_graph(new)
            by_id = {seen.object_id: seen for seen in one.objects}
            for number, seen in enumerate(two.objects, start=1):
                same = by_id[seen.object_id]
                assert (seen.number, seen.name, seen.point, seen.box) == (
                    number, same.name, same.point, same.box,
                )  # fmt: skip
            ids = {seen.number: seen.object_id for seen in one.objects}
            kept = {seen.object_id: seen.number for seen in two.objects}
            related = {(ids[a], kind, ids[b]) for a, kind, b in one.relations}
            wanted = {(kept[a], kind, kept[b]) for a, kind, b in related if {a, b} <= {*kept}}
            assert wanted == {*two.relations}


def test_nobody_speaks_of_what_is_left_out(thin):
    for before, after in thin:
        assert before.question == after.question and before.answer == after.answer
        ids = [
            set(re.findall(r"object_id: (object_\d+)", "\n".join(lists(it))))
            for it in (before, after)
        ]
        gone = {name for names in names_in(before) for name in names}
        gone -= {name for names in names_in(after) for name in names}
        for old, new in zip(before.steps, after.steps, strict=True):
            assert (old.call.name, old.call.arguments) == (new.call.name, new.call.arguments)
            spoken = f"{new.call.words} {new.call.arguments}"
            if new.call.name != "perceive_scene":
                assert new.text == old.text
                spoken += new.text
            assert not {*re.findall(r"object_\d+", spoken)} & (ids[0] - ids[1])
            assert not [name for name in gone if name and name in spoken]


def test_the_draw_alone_decides(episodes):
    task, record = next(it for it in episodes if it[0].question_type == "compare")
    told_so = [told(task, record, seed) for seed in (1, 1, 2)]
    assert told_so[0] == told_so[1] != told_so[2]


def test_where_all_are_spoken_of_none_is_left_out():
    """Two marked things, and the one that lies on one of them."""
    with pytest.raises(NotCertain, match="speaks of all things"):
        told(SIZE, taught())
