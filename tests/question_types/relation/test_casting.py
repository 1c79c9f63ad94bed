"""Who plays in Relation."""

from __future__ import annotations

import pytest

from probe.assets.library import Library
from probe.generation.likeness import sides_alike
from probe.generation.plan import plan
from probe.question_types.relation.casting import select_relation
from probe.scene.seeds import generator


@pytest.mark.parametrize("seed", range(2))
def test_three_like_covers_and_six_things_that_height_does_not_tell_apart(
    library: Library, seed: int
):
    cast = select_relation(library, plan("relation", 1000 * seed), generator(seed, "cast"))
    assert (len(cast.candidates), len(cast.beneath), len(cast.covers)) == (5, 1, 3)
    assert len({cover.spec.id for cover in cast.covers}) == 1
    hidden = [*cast.candidates, *cast.beneath]
    assert sides_alike(hidden, 0.1) and len({it.name for it in hidden}) == 6
