from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from probe.assets.library import open_library
from probe.assets.mesh.nearness import NearPair
from probe.assets.pools.split import (
    LeakingSplit,
    Split,
    check_split,
    groups_of,
    part_of,
    read_split,
    split_objects,
    write_split,
)
from probe.errors import BadData

IDS = [f"object_{number:03d}" for number in range(300)]


def _pair(one: int, other: int) -> NearPair:
    return NearPair(IDS[one], IDS[other], 0.01, 0.1)


PAIRS = st.lists(
    st.tuples(st.integers(0, 59), st.integers(0, 59)).filter(lambda pair: pair[0] < pair[1]),
    max_size=40,
)


@given(links=PAIRS)
def test_near_duplicates_are_never_parted(links):
    pairs = [_pair(*link) for link in links]
    made = split_objects(IDS[:60], pairs)
    assert sorted(made.parts) == IDS[:60]
    assert all(made.parts[pair.one] == made.parts[pair.other] for pair in pairs)
    assert split_objects(list(reversed(IDS[:60])), pairs[::-1]) == made


@given(links=PAIRS)
def test_groups_hold_every_object_once(links):
    groups = groups_of(IDS[:60], [_pair(*link) for link in links])
    assert sorted(name for group in groups for name in group) == IDS[:60]


def test_about_a_fifth_is_for_evaluation():
    made = split_objects(IDS, [])
    assert 40 <= len(made.ids("evaluation")) <= 80
    assert len(made.ids("evaluation")) + len(made.ids("train")) == 300


def test_new_objects_move_no_old_ones_and_join_their_near_duplicates():
    first = split_objects(IDS[:200], [])
    later = split_objects(IDS, [_pair(5, 250), _pair(250, 251)], first)
    assert {name: later.parts[name] for name in IDS[:200]} == first.parts
    assert later.parts[IDS[250]] == later.parts[IDS[251]] == first.parts[IDS[5]]


def test_a_near_duplicate_planted_across_parts_is_caught():
    made = split_objects(IDS, [])
    train, evaluation = made.ids("train")[0], made.ids("evaluation")[0]
    planted = NearPair(min(train, evaluation), max(train, evaluation), 0.01, 0.2)
    for attempt in (
        lambda: check_split(made, [planted]),
        lambda: split_objects(IDS, [planted], made),
    ):
        with pytest.raises(LeakingSplit, match=f"{train} is for training, but {evaluation}"):
            attempt()


def test_a_chain_across_parts_is_caught():
    made = split_objects(IDS, [])
    train, evaluation = made.ids("train")[0], made.ids("evaluation")[0]
    chain = [NearPair(train, "a_new_one", 0, 0), NearPair(evaluation, "a_new_one", 0, 0)]
    with pytest.raises(LeakingSplit):
        split_objects([*IDS, "a_new_one"], chain, made)


def test_a_split_is_stored_and_read(tmp_path):
    made = split_objects(IDS, [])
    write_split(tmp_path / "split.json", made)
    assert read_split(tmp_path / "split.json") == made
    (tmp_path / "split.json").write_text('{"parts": {"a": "test"}}')
    with pytest.raises(BadData, match=r"split\.json.*parts"):
        read_split(tmp_path / "split.json")
    with pytest.raises(BadData, match="probe assets split"):
        read_split(tmp_path / "none.json")


def test_a_part_of_a_library_holds_its_objects_alone(cache):
    library = open_library("procedural", None, cache)
    first = library.specs[0].id
    few = part_of(library, Split(parts={first: "evaluation"}), "evaluation")
    assert [spec.id for spec in few.specs] == [first]
