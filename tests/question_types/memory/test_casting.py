"""Who plays in Memory."""

from __future__ import annotations

import pytest

from probe.assets.library import Library
from probe.generation.likeness import sides_alike
from probe.generation.plan import plan
from probe.question_types.memory.casting import select_memory
from probe.scene.seeds import generator


@pytest.mark.parametrize("seed", range(2))
def test_three_unlike_covers_and_five_things_that_height_does_not_tell_apart(
    library: Library, seed: int
):
    cast = select_memory(library, plan("memory", 1000 * seed), generator(seed, "cast"))
    assert (len(cast.candidates), len(cast.beneath)) == (5, 0)
    assert len({cover.spec.name for cover in cast.covers}) == len(cast.covers) == 3
    assert sides_alike(cast.candidates, 0.1)
    assert len({spec.name for spec in cast.specs}) == len(cast.specs)
