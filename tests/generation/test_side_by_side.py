"""Who plays where several covers stand side by side, and where they stand."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from probe.assets.library import Library
from probe.generation.covers import Cover
from probe.generation.likeness import sides_alike
from probe.generation.object_selection import ObjectSelection
from probe.generation.plan import plan
from probe.generation.side_by_side import COVERS, draw_posts
from probe.generation.task_generator import generator_of
from probe.scene.seeds import generator
from tabletops import spec


def cover(width: float) -> Cover:
    return Cover(spec("red lid"), (1.0, 0.0, 0.0, 0.0), (width, width, 0.05), (0.0, 0.0), 0.0, 0.0)


@given(st.lists(st.floats(0.07, 0.16), min_size=3, max_size=3), st.integers(0, 10**6))
def test_covers_stand_clear_of_each_other_and_on_the_table(widths, seed):
    covers = [cover(width) for width in widths]
    posts = draw_posts(covers, 1.1, generator(seed, "posts"))
    for number, post in enumerate(posts):
        assert post.radius == pytest.approx(1.1 * covers[number].reach)
        assert math.hypot(post.x, post.y) + covers[number].reach < 0.25
        for other in posts[:number]:
            apart = math.hypot(post.x - other.x, post.y - other.y)
            assert apart >= post.radius + other.radius - 1e-9


@pytest.mark.parametrize("question_type", ["exact", "decoys"])
@pytest.mark.parametrize("seed", range(3))
def test_what_lies_beneath_the_covers_is_alike_and_can_be_told_apart(
    library: Library, question_type: str, seed: int
):
    rng = generator(seed, "cast")
    cast = generator_of(question_type).select(library, plan(question_type, 1000 * seed), rng)
    assert isinstance(cast, ObjectSelection)
    hidden = [*cast.candidates, *cast.beneath]
    assert (len(cast.candidates), len(cast.beneath), len(cast.covers)) == (5, COVERS - 1, COVERS)
    assert sides_alike(hidden, 0.1)
    kinds = {it.spec.id for it in cast.covers}
    assert len(kinds) == (1 if question_type == "decoys" else COVERS)
    names = [it.name for it in cast.specs]
    assert len(set(names)) == len(names) - (COVERS - len(kinds))
    numbers = (*range(1, 6), *cast.secrets, *cast.covering, *cast.crowd, *cast.toppings)
    assert numbers == tuple(range(1, len(cast.specs) + 1))
    for number, it in zip(cast.covering, cast.covers, strict=True):
        assert cast.specs[number - 1] is it.spec
