from __future__ import annotations

from collections import Counter
from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from probe.assets.spec import ObjectSpec
from probe.generation.alike import draw_alike, unlike
from probe.generation.likeness import Likeness, are_level, says_in_part, sides_alike, told_apart
from probe.generation.result import Rejected


def spec(name: str, category: str, colour: str, side: float) -> ObjectSpec:
    return ObjectSpec(
        name.replace(" ", "_"), name, category, (colour,), "A thing.", 0.1, 0.5,
        (side, side / 2, side / 2), False, "procedural", "Apache-2.0", "test",
    )  # fmt: skip


POOL = [
    spec(f"{colour} {question_type}", question_type, colour, 0.03 + 0.002 * place)
    for place, question_type in enumerate(
        ["ball", "block", "egg", "cork", "soap", "plum", "bead", "ring"]
    )
    for colour in ("red", "blue", "green")
]


@given(st.integers(0, 10**6), st.sampled_from([0.1, 0.25]))
def test_five_alike_can_be_told_apart_and_are_close_in_size(seed, tolerance):
    drawn = draw_alike(POOL, POOL, Likeness(tolerance), 5, np.random.default_rng(seed))
    sizes = [max(one.size) for one in drawn]
    assert len({one.name for one in drawn}) == 5
    assert len({(one.category, one.colours[0]) for one in drawn}) == 5
    assert max(sizes) / min(sizes) <= 1 + tolerance


@given(st.integers(0, 10**6))
def test_five_of_one_colour_are_told_apart_by_category(seed):
    drawn = draw_alike(POOL, POOL, Likeness(0.25, one_colour=True), 5, np.random.default_rng(seed))
    assert len({one.name.split()[0] for one in drawn}) == 1
    assert len({one.category for one in drawn}) == 5


def test_where_sides_are_alike_several_categories_are_preferred():
    balls = [spec(f"{colour} ball", "ball", colour, 0.04) for colour in "abcdef"]
    few = [spec(f"{kind} thing", kind, "red", 0.04) for kind in ("egg", "cork", "soap")]
    for seed in range(30):
        rng = np.random.default_rng(seed)
        drawn = draw_alike(
            [*balls, *few], [*balls, *few], Likeness(0.1, sides=0.1), 5, rng, varied=True
        )
        kinds = Counter(one.category for one in drawn)
        assert kinds == {"ball": 2, "egg": 1, "cork": 1, "soap": 1}
        assert len(draw_alike(balls, balls, Likeness(0.1, sides=0.1), 5, rng, varied=True)) == 5


def test_two_colours_are_not_one():
    pool = [spec(f"red and {o} {k}", k, "red", 0.04) for o in ("blue", "white") for k in "abc"]
    with pytest.raises(Rejected):
        draw_alike(pool, pool, Likeness(0.25, one_colour=True), 4, np.random.default_rng(0))


def test_common_and_rare_categories_are_not_mixed():
    library = [*POOL, *(spec(f"mug {n}", "mug", f"colour {n}", 0.04) for n in range(40))]
    for seed in range(50):
        drawn = draw_alike(library, library, Likeness(0.25), 5, np.random.default_rng(seed))
        assert len({one.category == "mug" for one in drawn}) == 1


def test_the_order_says_nothing_of_size():
    largest: Counter[int] = Counter()
    for seed in range(1000):
        drawn = draw_alike(POOL, POOL, Likeness(0.25), 5, np.random.default_rng(seed))
        sizes = [max(one.size) for one in drawn]
        if sizes.count(max(sizes)) == 1:
            largest[sizes.index(max(sizes))] += 1
    share = np.array([largest[place] for place in range(5)]) / largest.total()
    assert np.abs(share - 0.2).max() < 0.06


def test_too_few_alike_is_a_rejection():
    with pytest.raises(Rejected) as caught:
        draw_alike(POOL[:3], POOL, Likeness(0.1), 5, np.random.default_rng(0))
    assert caught.value.rejection.check == "candidates"


@pytest.mark.parametrize(
    ("a", "b", "apart"),
    [
        (spec("red mug", "mug", "red", 0.1), spec("blue mug", "mug", "blue", 0.1), True),
        (spec("red mug", "mug", "red", 0.1), spec("old mug", "mug", "red", 0.1), False),
        (spec("thing", "mug", "red", 0.1), spec("thing", "bowl", "blue", 0.1), False),
        (spec("red mug", "mug", "red", 0.1), spec("red bowl", "bowl", "red", 0.1), True),
    ],
)
def test_names_are_unambiguous(a, b, apart):
    assert told_apart([a, b]) is apart
    assert unlike([a], [b]) == ([a] if apart else [])


@given(st.integers(0, 10**6))
def test_those_that_lead_come_first_and_others_help_out(seed):
    def leads(one: ObjectSpec) -> bool:
        return one.category in {"ball", "block"} and one.name != "red block"

    drawn = draw_alike(POOL, POOL, Likeness(0.25), 6, np.random.default_rng(seed), leads=leads)
    # Five lead and are alike in size; whoever is drawn first of them has the others beside it.
    assert [leads(one) for one in drawn] == [True] * 5 + [False]


def test_why_nothing_can_be_drawn_is_told():
    with pytest.raises(Rejected, match="nothing here is of the right size"):
        draw_alike([], POOL, Likeness(0.25), 5, np.random.default_rng(0))
    with pytest.raises(Rejected, match=r"only 3 of 5 alike: .*red ball"):
        draw_alike(POOL[:3], POOL, Likeness(0.25), 5, np.random.default_rng(0))


def test_where_all_sides_count_a_taller_one_is_not_taken():
    tall = [replace(one, size=(*one.size[:2], 2 * one.size[2])) for one in POOL if "red" in one.id]
    pool = [*(one for one in POOL if "red" not in one.id), *tall]
    for seed in range(20):
        rng = np.random.default_rng(seed)
        drawn = draw_alike(pool, pool, Likeness(0.1, sides=0.1), 4, rng)
        assert sides_alike(drawn, 0.1)
        heights = [one.size[2] for one in drawn]
        assert max(heights) <= 1.1 * min(heights)
    assert any(
        not sides_alike(draw_alike(pool, pool, Likeness(0.1), 4, np.random.default_rng(seed)), 0.1)
        for seed in range(20)
    )


def test_where_things_must_be_level_a_slightly_taller_one_is_not_taken():
    tall = [replace(it, size=(*it.size[:2], it.size[2] + 2e-3)) for it in POOL if "red" in it.id]
    pool = [*(one for one in POOL if "red" not in one.id), *tall]
    sets = [
        draw_alike(pool, pool, Likeness(0.25, level=1e-3), 4, np.random.default_rng(n))
        for n in range(9)
    ]
    assert all(are_level(drawn, 1e-3) for drawn in sets)
    loose = [
        draw_alike(pool, pool, Likeness(0.25), 4, np.random.default_rng(seed)) for seed in range(9)
    ]
    assert not all(are_level(drawn, 1e-3) for drawn in loose)


def test_where_names_are_to_be_whole_no_other_one_may_hold_them():
    plain = [replace(it, name=it.category) for it in POOL if "red" in it.id]
    pool = [*(it for it in POOL if "red" not in it.id), *plain]
    for asked in (False, True):
        drawn = [
            draw_alike(
                pool, pool, Likeness(0.25, whole_names=asked), 5, np.random.default_rng(seed)
            )
            for seed in range(30)
        ]
        told = [says_in_part(a.name, b.name) for it in drawn for a, b in combinations(it, 2)]
        assert any(told) != asked
