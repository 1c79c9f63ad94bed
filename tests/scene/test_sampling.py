"""What a scene holds and how it falls."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from probe.assets.spec import ObjectSpec
from probe.errors import Unsatisfiable
from probe.scene.sampling import PileSettings, draw_drop, draw_objects, draw_pile
from probe.scene.seeds import generator
from probe.scene.setup import UR5_TABLE
from probe.types import Pose


def spec(number: int, name: str, category: str, colour: str) -> ObjectSpec:
    return ObjectSpec(
        f"o{number}", name, category, (colour,), "", 0.1, 0.5, (0.1, 0.1, 0.1), False,
        "procedural", "Apache-2.0", "test",
    )  # fmt: skip


LIBRARY = [
    spec(8 * n + k, f"{colour} {category}", category, colour)
    for n, category in enumerate(("mug", "bowl", "book", "box"))
    for k, colour in enumerate(("red", "red", "blue", "green", "green", "tan", "tan", "black"))
]


@given(st.integers(0, 10_000), st.integers(1, 20))
def test_names_are_unique_and_categories_differ_in_colour(seed, count):
    drawn = draw_objects(LIBRARY, count, np.random.default_rng(seed))
    assert len(drawn) == count
    assert len({s.name for s in drawn}) == count
    assert len({(s.category, s.colours[0]) for s in drawn}) == count


def test_too_many_is_refused_with_the_numbers():
    with pytest.raises(Unsatisfiable, match="Only 20 of 21"):
        draw_objects(LIBRARY, 21, np.random.default_rng(0))


@given(st.integers(0, 10_000))
def test_drops_stay_in_reach_with_unit_rotations(seed):
    drop = draw_drop(np.random.default_rng(seed), reach=0.1)
    assert max(abs(drop.x), abs(drop.y)) <= 0.1
    assert np.linalg.norm(drop.wxyz) == pytest.approx(1)


SIZES = st.tuples(*[st.floats(0.02, 0.3)] * 3)


@given(st.integers(0, 10_000), st.lists(SIZES, min_size=2, max_size=15), st.integers(0, 9))
def test_what_is_buried_falls_first_and_something_flat_lands_on_it(seed, sizes, buried):
    specs = [replace(LIBRARY[n], size=size) for n, size in enumerate(sizes)]
    falls = draw_pile(specs, PileSettings(0.1, buried), np.random.default_rng(seed))
    assert sorted(index for index, _ in falls) == list(range(len(specs)))
    pairs = min(buried, len(specs) // 2)
    smallest = sorted(range(len(specs)), key=lambda n: -np.prod(sizes[n]))[len(specs) - pairs :]
    first, over = falls[: 2 * pairs : 2], falls[1 : 2 * pairs : 2]
    for (small, below), (large, above) in zip(first, over, strict=True):
        assert small in smallest and large not in smallest
        assert np.hypot(above.x - below.x, above.y - below.y) < 0.015
        thin = np.eye(3)[int(np.argmin(sizes[large]))]
        assert abs(Pose((0, 0, 0), above.wxyz).apply(thin)[2]) == pytest.approx(1)


@pytest.mark.parametrize("pile", [(0.0, 0), (0.3, 0), (float("nan"), 0), (0.1, -1)])
def test_a_pile_that_cannot_be_is_refused(pile):
    with pytest.raises(Unsatisfiable):
        PileSettings(*pile).check_reach(UR5_TABLE)


def test_generators_depend_on_seed_and_purpose_alone():
    def first(*key: int | str) -> float:
        seed, *purpose = key
        return generator(int(seed), *purpose).random()

    assert first(1, "table") == first(1, "table")
    assert len({first(1, "table"), first(2, "table"), first(1, "pile"), first(1, "pile", 0)}) == 4
