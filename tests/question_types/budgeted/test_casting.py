"""Who plays in Budgeted: two of five covers are too small for what is asked for."""

from __future__ import annotations

import itertools
from collections import Counter
from contextlib import suppress
from dataclasses import replace

import pytest

from probe.assets.library import Library
from probe.generation.alike import is_lying
from probe.generation.likeness import longest
from probe.generation.object_selection import ObjectSelection
from probe.generation.plan import plan
from probe.generation.result import Rejected
from probe.question_types.budgeted.casting import SMALL, WIDE, select_budgeted
from probe.question_types.budgeted.sizes import across, told_length, too_small
from probe.scene.seeds import generator
from tabletops import spec


def cast_of(library: Library, seed: int) -> ObjectSelection:
    """The first that is found from a seed on."""
    for number in itertools.count(1000 * seed):
        with suppress(Rejected):
            its_plan = plan("budgeted", number)
            return select_budgeted(library, its_plan, generator(number, "cast"))
    raise AssertionError


@pytest.mark.slow
def test_casts_are_of_many_kinds(library: Library):
    led = Counter(cast_of(library, seed).candidates[0].category for seed in range(6))
    assert len(led) >= 3 and max(led.values()) <= 3


@pytest.mark.parametrize("seed", range(3))
def test_three_covers_have_room_for_any_candidate_and_two_for_none(library: Library, seed: int):
    cast = cast_of(library, seed)
    sizes = [longest(it) for it in cast.candidates]
    assert max(sizes) <= 1.1 * min(sizes) and all(map(is_lying, cast.candidates))
    assert len(cast.covers) == WIDE + SMALL and len(cast.beneath) == WIDE + SMALL - 1
    assert all(1.25 * longest(it) <= min(sizes) for it in cast.beneath)
    narrow = [it for it in cast.covers if too_small(library, it.spec.id, min(sizes))]
    assert len(narrow) == SMALL
    for cover in cast.covers:
        wide = across(library, cover.spec.id)
        assert max(cover.extent[:2]) - 1e-6 <= wide
        if cover in narrow:
            assert 1.15 * wide <= min(sizes)
        else:
            assert cover.width >= max(sizes)


def test_the_length_that_is_told_is_that_of_no_candidate_but_of_all():
    things = [replace(spec("red pen"), size=(it, 0.02, 0.01)) for it in (0.08, 0.0865)]
    assert told_length(things) == told_length(things[::-1]) == "8.5"
    assert told_length([things[0]]) == "8"
