"""What can be made of a library is known beforehand, and by the generators' own rules."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from probe.assets.cache import Cache
from probe.assets.library import Library, open_library
from probe.assets.looks import Looks
from probe.assets.mesh.mesh import Body
from probe.assets.pools.procedural import procedural_body, procedural_key
from probe.generation import feasibility
from probe.generation.build import rules_for
from probe.generation.build_folder import TaskSlot
from probe.generation.feasibility import possibilities
from probe.generation.object_selection import LEAST_LEADING
from probe.generation.plan import plan_of
from probe.generation.result import Rejected
from probe.generation.task_generator import generator_of
from probe.generation.task_plan import TaskPlan
from probe.question_types.beneath.generator import select_beneath
from probe.question_types.count.generator import select_count
from probe.question_types.find.generator import select_find
from probe.question_types.size.generator import draw_pairs
from probe.tasks.task import QUESTION_TYPES

SOME = (
    "proc_lime",
    "proc_lemon",
    "proc_golf_ball",
    "proc_red_mug",
    "proc_white_bowl",
    "proc_red_book",
    "proc_corn_can",
)


class Mixed(Library):
    """Its own things have the bodies of the built-in ones with their ids."""

    def _body_file(self, object_id: str, looks: Looks) -> Path:
        return Cache(self.cache / "bodies").path(procedural_key(object_id, looks))

    def body(self, object_id: str, looks: Looks = 1) -> Body:
        bodies, data = Cache(self.cache / "bodies"), Cache(self.cache / "specs")
        return procedural_body(object_id, bodies, data, looks)

    def form(self, object_id: str) -> Body:
        return self.body(object_id)


@pytest.fixture(scope="module")
def mixed(library: Library) -> Library:
    """A library in which a few things, formula-made like the others, are somebody's own."""
    known = {spec.id for spec in library.specs}
    assert known.issuperset(SOME), known
    specs = tuple(
        replace(spec, origin="own") if spec.id in SOME else spec for spec in library.specs
    )
    return Mixed(specs, None, library.cache, leading="own", pool=library.pool)


def test_things_of_ones_own_are_asked_about_by_the_older_rules(library: Library, mixed: Library):
    """Few of them have four others that are alike in length, width and height."""
    assert (rules_for(library), rules_for(mixed)) == (3, 2)


def test_a_library_of_one_thing_allows_nothing_and_says_why(library: Library):
    lone = replace(library, specs=(library["proc_red_mug"],))
    found = {
        it.question_type: it
        for it in possibilities(
            [TaskSlot(question_type, 0) for question_type in QUESTION_TYPES], lone
        )
    }
    assert all(it.hopeless == it.places for it in found.values())
    assert "right size" in found["beneath"].missing[0]
    assert "paint" in found["compare"].missing[0]
    assert "marked" in found["size"].missing[0]
    assert "7 to 12.5 cm wide" in found["beneath"].needs


@pytest.mark.slow
def test_all_of_the_library_allows_every_type(library: Library):
    places = [
        TaskSlot(question_type, 0) for question_type in QUESTION_TYPES if question_type != "compare"
    ]
    assert [it.hopeless for it in possibilities(places, library)] == [()] * len(places)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("draw", "question_type"), [(select_beneath, "beneath"), (select_find, "find")]
)
def test_what_is_hidden_is_of_ones_own_where_enough_are(mixed: Library, draw, question_type):
    for seed in range(3):
        cast = draw(mixed, plan_of(question_type, 0, rules=2), np.random.default_rng(seed))
        own = [spec.id in SOME for spec in cast.candidates]
        if sum(own) >= LEAST_LEADING:
            assert [own[index] for index in cast.eligible] == [True] * sum(own)
        else:
            assert any(cover.spec.id in SOME for cover in cast.covers)
            assert cast.eligible == (0, 1, 2, 3, 4)


@pytest.mark.slow
def test_what_is_counted_is_of_ones_own(mixed: Library):
    wanted = plan_of("count", 0, rules=2)
    casts = [select_count(mixed, wanted, np.random.default_rng(k)) for k in range(4)]
    assert all(cast.counted.id in SOME for cast in casts)


def test_pairs_always_have_one_of_ones_own_and_often_two_at_first(mixed: Library):
    began_alone = 0
    for seed in range(40):
        pairs = list(draw_pairs(mixed, np.random.default_rng(seed)))
        own = [sum(spec.id in SOME for spec in pair) for pair in pairs]
        assert min(own) >= 1 and min(own[len(own) // 2 :]) == 1
        assert all(one is not other for one, other in pairs)
        began_alone += set(own[: len(own) // 2]) == {2}
    assert 10 <= began_alone <= 30  # half, to within three standard deviations


def test_nobody_compares_paints_of_others_things(mixed: Library):
    (found,) = possibilities([TaskSlot("compare", 0)], mixed)
    assert found.hopeless and "of your own" in found.missing[0]


@pytest.mark.slow
def test_a_place_whose_first_castings_fail_is_tried_longer_where_others_can_be_cast(cache: Path):
    """One casting of Budgeted in twelve finds five covers: for this place the 52nd."""
    evaluation, unlucky = open_library("evaluation", None, cache), TaskSlot("budgeted", 50000)
    (alone,) = possibilities([unlucky], evaluation)
    assert alone.hopeless == (unlucky,)
    places = [unlucky, TaskSlot("budgeted", 50001)]
    for made in ([], places[1:]):
        (found,) = possibilities(places, evaluation, made=made)
        assert (found.hopeless, found.missing) == ((), ())


@pytest.mark.slow
def test_a_place_that_stays_impossible_beside_others_says_why(library: Library, monkeypatch):
    wanted, select = TaskSlot("count", 1), generator_of("count").select

    def none_for_the_second(library: Library, plan: TaskPlan, rng: np.random.Generator):
        if plan == plan_of(*wanted):
            raise Rejected("candidates", "nothing is there")
        return select(library, plan, rng)

    only = replace(generator_of("count"), select=none_for_the_second)
    monkeypatch.setattr(feasibility, "generator_of", lambda _: only)
    (found,) = possibilities([TaskSlot("count", 0), wanted], library)
    assert found.hopeless == (wanted,) and "nothing is there" in found.missing[0]
