"""Groups and categories between training and evaluation, without any mesh."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from probe.assets.pools.dividing import divide, in_parts
from probe.assets.pools.division import Part
from probe.errors import BadData

GROUPS = st.lists(
    st.tuples(st.integers(1, 3), st.sampled_from("abcd"), st.booleans()), min_size=1, max_size=40
)
"""For each group how many objects it has, of which category, and whether a suite has shown one."""


def imagined(
    drawn: list[tuple[int, str, bool]],
) -> tuple[list[list[str]], dict[str, str], set[str]]:
    groups = [
        [f"object_{number:02d}_{member}" for member in range(size)]
        for number, (size, _, _) in enumerate(drawn)
    ]
    categories = {
        it: category for group, (_, category, _) in zip(groups, drawn, strict=True) for it in group
    }
    shown = {group[-1] for group, (_, _, seen) in zip(groups, drawn, strict=True) if seen}
    return groups, categories, shown


@given(drawn=GROUPS)
def test_groups_stay_whole_and_what_was_shown_is_for_evaluation(drawn):
    groups, categories, shown = imagined(drawn)
    rows = divide(groups, categories, dict.fromkeys(shown, "evaluation"))
    assert [row.id for row in rows] == sorted(categories)
    parts = {row.id: row.part for row in rows}
    assert all(parts[it] == "evaluation" for it in shown)
    for group in groups:
        assert len({parts[it] for it in group}) == 1
    assert {row.group for row in rows} == {group[0] for group in groups}


@given(drawn=GROUPS)
def test_categories_of_several_groups_are_in_both_parts_where_that_can_be(drawn):
    groups, categories, shown = imagined(drawn)
    parts = in_parts(divide(groups, categories, dict.fromkeys(shown, "evaluation")), categories)
    for category in set(categories.values()):
        mine = [group for group in groups if categories[group[0]] == category]
        free = [group for group in mine if shown.isdisjoint(group)]
        if len(mine) > 1 and free:
            assert parts[category] == {"train", "evaluation"}


def test_a_share_of_many_groups_is_for_evaluation():
    groups = [[f"cup_{number:02d}"] for number in range(50)]
    rows = divide(groups, {group[0]: "cup" for group in groups}, {})
    assert sum(row.part == "evaluation" for row in rows) == 15


def test_a_later_object_moves_no_earlier_one():
    ids = [f"cup_{number:02d}" for number in range(12)]
    categories = dict.fromkeys(ids, "cup")
    rows = divide([[it] for it in ids[:5]], categories, {})
    first: dict[str, Part] = {row.id: row.part for row in rows}
    groups = [[it] for it in ids if it not in ("cup_02", "cup_11")] + [["cup_02", "cup_11"]]
    later = {row.id: row.part for row in divide(groups, categories, first)}
    assert {it: later[it] for it in first} == first
    assert later["cup_11"] == first["cup_02"]


def test_near_duplicates_that_have_a_place_on_both_sides_are_an_error():
    fixed: dict[str, Part] = {"a": "train", "b": "evaluation"}
    with pytest.raises(BadData, match="a is for training, b for evaluation, and they are near"):
        divide([["a", "b"]], {"a": "cup", "b": "cup"}, fixed)
