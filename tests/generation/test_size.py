"""Who plays in Size, before anything is laid."""

from __future__ import annotations

import numpy as np
import pytest

from probe.assets.library import Library
from probe.generation.palettes import main_colour
from probe.generation.plan import ATTEMPTS, plan
from probe.generation.result import Rejected
from probe.generation.task_plan import MORE_CUES
from probe.question_types.size.generator import LIGHTER, select_size


@pytest.mark.slow
def test_the_longer_cover_goes_where_it_is_planned_and_both_things_are_of_a_size(library: Library):
    larger_by_place = []
    for episode in range(12):
        wanted = plan("size", episode * ATTEMPTS)
        try:
            cast = select_size(library, wanted, np.random.default_rng(episode))
        except Rejected:
            continue
        a, b = (cover.spec for cover in cast.covers)
        larger = "AB".index(wanted.letter) ^ (wanted.form == "smaller")
        longer = int(max(b.size) > max(a.size))
        assert (longer == larger) == MORE_CUES.of(wanted)[1] or max(a.size) == max(b.size)
        bare = [np.prod(sorted(spec.size)[-2:]) for spec in cast.marked]
        assert max(bare) <= 2.5 * min(bare)
        light = [main_colour(library, spec.id)[0] for spec in cast.marked]
        assert (light[larger] > light[1 - larger]) == LIGHTER.of(wanted)
        larger_by_place.append(larger)
    assert set(larger_by_place) == {0, 1} and len(larger_by_place) >= 8
