"""Who lies beside whom."""

from __future__ import annotations

import pytest

from probe.generation.bystanders import draw_bystanders
from probe.scene.seeds import generator


@pytest.mark.parametrize("seed", range(20))
@pytest.mark.parametrize("count", [1, 2])
def test_each_candidate_comes_once_at_each_place_and_never_beside_itself(seed: int, count: int):
    beside = draw_bystanders(count, generator(seed, "beside"))
    for place in zip(*beside, strict=True):
        assert sorted(place) == [0, 1, 2, 3, 4]
    scenes = [(index, *others) for index, others in enumerate(beside)]
    assert all(len(set(scene)) == 1 + count for scene in scenes)


def test_who_lies_beside_whom_is_drawn():
    assert len({tuple(draw_bystanders(2, generator(seed, "beside"))) for seed in range(20)}) > 5
