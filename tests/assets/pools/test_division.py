"""The stored division of the built-in objects; `test_pools_apart.py` measures the objects."""

from __future__ import annotations

from collections import defaultdict
from importlib.resources import files

import pytest

from probe.assets.library import EVALUATION_POOL, TRAINING_POOL, open_library
from probe.assets.pools.dividing import in_parts
from probe.assets.pools.division import (
    DIVISION,
    divided,
    division_text,
    parse_division,
    part_of_object,
    parts_shown,
    shown_of,
)
from probe.assets.procedural.tables import entries
from probe.errors import BadData

TRAINED, EVALUATED = "proc_orange_mug", "proc_red_mug"


def test_every_object_is_in_exactly_one_pool(cache):
    pools = {
        pool: [spec.id for spec in open_library(pool, None, cache).specs]
        for pool in (TRAINING_POOL, EVALUATION_POOL, "procedural-2")
    }
    train, evaluation = (set(pools[pool]) for pool in (TRAINING_POOL, EVALUATION_POOL))
    assert train.isdisjoint(evaluation)
    assert train | evaluation == set(pools["procedural-2"]) == set(divided())
    # In the order of the whole library, so that the same seed draws the same.
    assert pools["train"] == [it for it in pools["procedural-2"] if it in train]


def test_what_the_published_suites_show_is_for_evaluation():
    assert {part_of_object(it) for it in entries(1)} == {"evaluation"}


def test_groups_are_whole_and_named_after_their_first():
    members = defaultdict[str, list[str]](list)
    for row in divided().values():
        members[row.group].append(row.id)
        assert divided()[row.group].part == row.part
    assert all(group == min(ids) for group, ids in members.items())


def test_categories_are_in_both_pools():
    categories = {it.id: it.category for it in entries(2).values()}
    parts = in_parts(divided().values(), categories)
    published = {categories[it] for it in entries(1)}
    shown = {divided()[it].group for it in entries(1)}
    spanned, free = defaultdict[str, set[str]](set), defaultdict[str, set[str]](set)
    for row in divided().values():
        spanned[row.group].add(categories[row.id])
    for row in divided().values():
        if row.group not in shown:
            free[categories[row.id]].add(row.group)
    for category, mine in free.items():
        alone = [group for group in mine if len(spanned[group]) == 1]
        if category in published or len(alone) > 1:
            assert len(parts[category]) == 2, category
    # What is alone is food that can't be had in other colours, and the like.
    assert sum(len(it) == 2 for it in parts.values()) > 0.7 * len(parts)


def test_training_has_covers_small_things_and_things_that_differ_in_paint_alone(cache):
    for pool in (TRAINING_POOL, EVALUATION_POOL):
        specs = open_library(pool, None, cache).specs
        assert len(specs) > 1000
        assert sum(spec.hollow and min(spec.size[:2]) >= 0.10 for spec in specs) >= 60
        assert sum(max(spec.size) <= 0.08 for spec in specs) >= 100


def test_which_pool_objects_are_of():
    assert (part_of_object(TRAINED), part_of_object("own_cup")) == ("train", None)
    assert parts_shown([TRAINED, TRAINED, EVALUATED, "own_cup"]) == {
        "train": 1, "evaluation": 1, None: 1,
    }  # fmt: skip
    assert shown_of([EVALUATED, "own_cup"]) == "evaluation"
    assert shown_of([TRAINED]) == "train"
    assert shown_of([TRAINED, EVALUATED]) == "both"
    assert shown_of(["own_cup"]) is shown_of([]) is None


def test_the_file_is_read_and_written():
    text = (files("probe.assets") / "data" / DIVISION).read_text("utf-8")
    assert division_text(parse_division(text)) == text


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("object,pool\n", "has the columns object, pool"),
        ("object,group,pool\na,a,test\n", "line 2 is 'a,a,test'"),
        ("object,group,pool\na,a\n", "line 2 is 'a,a'"),
        ("object,group,pool\na,a,train\na,a,train\n", "an object is there twice"),
    ],
)
def test_a_damaged_file_is_refused(text, told):
    with pytest.raises(BadData, match=told):
        parse_division(text)
