from __future__ import annotations

import numpy as np
import pytest

from probe.assets.library import Library
from probe.generation.covers import cover_of
from probe.generation.stage import Layer, Stage, about_z, draw_clear_drop
from probe.scene.setup import UR5_TABLE
from probe.types import Pose
from probe.world.model import Post

LIME, MUG, BOOK = 1, 2, 3
CROWD = (4, 5, 6, 7)
IDS = (
    *("proc_lime", "proc_red_mug", "proc_red_book"),
    *("proc_cracker_box", "proc_corn_can", "proc_banana", "proc_red_apple"),
)
POST = Post(0.03, -0.02, 0.07)


@pytest.fixture(scope="module")
def stage(library: Library) -> Stage:
    return Stage([library[id] for id in IDS], library, [POST], UR5_TABLE)


@pytest.fixture(scope="module")
def nest(stage: Stage, library: Library):
    cover = cover_of(library, "proc_red_mug")
    assert cover is not None
    return stage.nest(LIME, [Layer(MUG, cover, np.zeros(2), 1.0)], POST)


def middle(stage: Stage, instance: int, pose: Pose) -> np.ndarray:
    """Middle of an object's bounds."""
    corners = pose.apply(stage.items[instance - 1].body.mesh.vertices)
    return (corners.min(axis=0) + corners.max(axis=0)) / 2


def test_a_nest_holds_the_target_beneath_its_cover(stage: Stage, nest):
    assert set(nest) == {LIME, MUG}
    assert stage.covered_share(LIME, MUG, nest) == 1
    assert stage.covered_share(MUG, LIME, nest) < 0.5
    assert np.hypot(*(middle(stage, LIME, nest[LIME])[:2] - (POST.x, POST.y))) < 0.03


def test_the_crowd_settles_around_a_nest_that_stays_where_it_is(stage: Stage, nest):
    heap = stage.heap(nest, CROWD, np.random.default_rng(0))
    assert set(heap) == {LIME, MUG, *CROWD}
    for number in (LIME, MUG):
        assert np.allclose(heap[number].position, nest[number].position, atol=2e-4)
    for number in CROWD:
        assert np.abs(middle(stage, number, heap[number])[:2]).max() < 0.29
        assert np.hypot(*(middle(stage, number, heap[number])[:2] - (POST.x, POST.y))) > 0.05
    settled = stage.settle(heap)
    assert set(settled) == set(heap)
    assert stage.covered_share(LIME, MUG, settled) > 0.95


def test_what_stood_on_a_thing_comes_down_when_that_vanishes(stage: Stage, library: Library):
    top = library["proc_red_book"].size[2]
    poses = {BOOK: Pose(), LIME: Pose((0.0, 0.0, top + 0.001))}
    assert stage.settle(poses)[LIME].position[2] == pytest.approx(top, abs=0.006)
    lifted = stage.lift(poses, BOOK)
    assert set(lifted) == {LIME}
    assert lifted[LIME].position[2] == pytest.approx(0.0, abs=0.006)


def test_what_was_moved_leaves_nothing_behind(stage: Stage, nest):
    stage.settle({BOOK: Pose(), LIME: Pose((0.0, 0.0, 0.05))})
    alone = stage.settle({LIME: Pose((0.0, 0.0, 0.001))})
    assert alone[LIME].position[2] == pytest.approx(0.0, abs=0.006)


def test_drops_keep_clear_of_posts(library: Library):
    rng = np.random.default_rng(0)
    spec = library["proc_lime"]
    for _ in range(100):
        drop = draw_clear_drop(spec, [POST], 0.17, rng, UR5_TABLE.work_area)
        assert np.hypot(drop.x - POST.x, drop.y - POST.y) > POST.radius
        assert max(abs(drop.x), abs(drop.y)) <= 0.17


def test_a_turn_about_the_vertical():
    turned = Pose(wxyz=about_z(np.pi / 2)).apply(np.array([[1.0, 0.0, 0.5]]))
    assert turned == pytest.approx(np.array([[0.0, 1.0, 0.5]]))


def test_what_leans_stays_as_it_was_although_a_post_stands_in_it(stage: Stage, library: Library):
    book = cover_of(library, "proc_red_book")
    assert book is not None
    beside = Post(POST.x + 0.06, POST.y, POST.radius)
    leaning = stage.nest(LIME, [Layer(BOOK, book, np.array([-0.06, 0.0]), 1.0)], beside)
    poses = stage.heap(leaning, CROWD, np.random.default_rng(5))
    for instance, pose in leaning.items():
        assert poses[instance].position == pytest.approx(pose.position, abs=0.001)
