"""What lies beneath the covers of Ranked: options' sizes tell nothing of the answer."""

from __future__ import annotations

import itertools
import math
from collections import Counter
from contextlib import suppress
from dataclasses import replace

import pytest
from hypothesis import given
from hypothesis import strategies as st

from probe.assets.library import Library
from probe.generation.alike import is_lying
from probe.generation.likeness import longest, told_apart
from probe.generation.plan import plan
from probe.generation.result import Rejected
from probe.generation.side_by_side import Hidden
from probe.question_types.ranked.casting import draw_companions, select_ranked
from probe.question_types.ranked.ladder import companions, draw_ladder, looks_ordered
from probe.question_types.ranked.rules import RANKS
from probe.question_types.ranked.truth import has_rank
from probe.scene.seeds import generator
from probe.tasks.options import CANDIDATES, drop_one
from probe.tasks.task import LETTERS
from tabletops import spec

DRAWS = 40


def sized(*size: float):
    return replace(spec("red pen"), size=size)


@pytest.fixture(scope="module", params=RANKS)
def form(request: pytest.FixtureRequest) -> str:
    return request.param


@pytest.fixture(scope="module")
def ladders(library: Library, form: str) -> list[Hidden]:
    """So many as are wanted; a few tries find none."""
    drawn: list[Hidden] = []
    for seed in itertools.count():
        with suppress(Rejected):
            drawn.append(draw_ladder(library, form, generator(seed, "ladder")))
        if len(drawn) == DRAWS:
            break
    return drawn


def test_each_candidate_can_have_the_rank_whatever_its_size(ladders: list[Hidden], form: str):
    for hidden in ladders:
        specs = (*hidden.candidates, *hidden.secrets)
        lengths = [longest(it) for it in specs]
        assert len(hidden.candidates) == CANDIDATES and told_apart(specs)
        assert all(map(is_lying, specs))
        for index in range(CANDIDATES):
            # Beside the two that frame the candidates, each has it; so no size rules one out.
            assert has_rank(form, lengths[index], lengths[CANDIDATES:])
            pairs = companions(form, specs, index)
            assert pairs and all(index not in pair for pair in pairs)
            assert all(has_rank(form, lengths[index], [lengths[n] for n in it]) for it in pairs)
            assert all(looks_ordered(specs[n] for n in (index, *it)) for it in pairs)
        rivalled = sum(companions(form, specs, n)[0][0] < CANDIDATES for n in range(CANDIDATES))
        assert rivalled >= 3


def test_the_answers_place_by_size_is_even_among_all_and_among_the_options(ladders: list[Hidden]):
    places, offered = Counter[int](), Counter[int]()
    for seed, hidden in enumerate(ladders):
        order = sorted(hidden.candidates, key=longest)
        names = [it.name for it in hidden.candidates]
        # The candidates of one draw take turns, as the draw of the true one has them do.
        for true, letter in enumerate(LETTERS):
            rng = generator(seed, "options", true)
            places[order.index(hidden.candidates[true])] += 1
            options = [it.text for it in drop_one(names, true, letter, rng)][:-1]
            if names[true] in options:
                shown = [it.name for it in order if it.name in options]
                offered[shown.index(names[true])] += 1
    assert set(places.values()) == {DRAWS}
    assert min(offered.values()) > 0.75 * sum(offered.values()) / 4


def test_companions_are_other_candidates_where_these_will_do():
    lengths = [0.05, 0.051, 0.065, 0.066, 0.067, 0.04, 0.03]
    specs = [sized(length, 0.01, 0.01) for length in lengths]
    assert companions("longest", specs, 0) == [(5, 6)]
    rivals = companions("longest", specs, 2)
    assert rivals == [(0, 5), (0, 6), (1, 5), (1, 6)]


def test_the_one_that_is_there_comes_with_its_companions(library: Library):
    for seed in range(3):
        its_plan, rng = plan("ranked", 1000 * seed), generator(seed, "cast")
        cast = select_ranked(library, its_plan, rng)
        lengths = [longest(it) for it in (*cast.candidates, *cast.beneath)]
        assert {it.spec.id for it in cast.covers} == {cast.covers[0].spec.id}
        assert all(cast.covers[0].depth >= it.size[2] for it in cast.candidates)
        for index, pair in enumerate(draw_companions(cast, its_plan.form, rng)):
            others = [lengths[number - 1] for number in pair]
            assert has_rank(its_plan.form, lengths[index], others)


@given(st.floats(0.03, 0.06), st.floats(0.1, 1.0), st.floats(0, math.pi))
def test_however_a_shorter_thing_is_turned_its_box_is_not_the_longer_one(long, narrow, turn):
    shorter = sized(long, narrow * long, 0.01)
    longer = sized(math.hypot(long, narrow * long), 0.01, 0.01)
    wide = long * abs(math.cos(turn)) + narrow * long * abs(math.sin(turn))
    high = long * abs(math.sin(turn)) + narrow * long * abs(math.cos(turn))
    assert looks_ordered((shorter, longer)) and max(wide, high) <= max(longer.size) + 1e-9
    assert not looks_ordered((shorter, sized(0.999 * longer.size[0], 0.01, 0.01)))


def test_what_stands_upright_does_not_lie():
    assert is_lying(sized(0.05, 0.02, 0.05)) and not is_lying(sized(0.05, 0.02, 0.051))
