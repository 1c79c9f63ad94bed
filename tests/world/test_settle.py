"""Piles come to rest by the rules, or are refused."""

import mujoco
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from bodies import ball_item, box_item
from probe.errors import Unsatisfiable
from probe.scene.sampling import Drop, draw_drop
from probe.scene.setup import UR5_TABLE
from probe.world.model import add_item, new_spec
from probe.world.settle import settle

UPRIGHT = (1.0, 0.0, 0.0, 0.0)


def few_items():
    return [
        box_item(1, "red box", (0.12, 0.08, 0.05), 0.3),
        box_item(2, "blue book", (0.20, 0.14, 0.02), 0.4),
        ball_item(3, "white ball", 0.03, 0.05),
        box_item(4, "green block", (0.04, 0.04, 0.04), 0.05),
        box_item(5, "tan post", (0.03, 0.03, 0.16), 0.2),
    ]


@settings(max_examples=5, deadline=None)
@given(st.integers(0, 10_000))
def test_a_settled_pile_stays_on_an_independent_model(seed):
    items, rng = few_items(), np.random.default_rng(seed)
    placed = settle(items, {item.instance: draw_drop(rng) for item in items}, rng)
    assert [item.instance for item in placed] == [1, 2, 3, 4, 5]
    spec = new_spec(UR5_TABLE.table_size)
    for item, there in zip(items, placed, strict=True):
        body = add_item(spec, item)
        body.pos, body.quat = there.pose.position, there.pose.wxyz
    model = spec.compile()
    model.opt.enableflags = 0
    data = mujoco.MjData(model)
    start = data.qpos.reshape(-1, 7)[:, :3].copy()
    mujoco.mj_step(model, data, round(2 / model.opt.timestep))
    assert np.linalg.norm(data.qpos.reshape(-1, 7)[:, :3] - start, axis=1).max() < 0.001
    assert data.contact.dist.min() > -0.003


def test_same_seed_same_poses_to_the_bit():
    results = []
    for _ in range(2):
        items, rng = few_items(), np.random.default_rng(7)
        results.append(settle(items, {item.instance: draw_drop(rng) for item in items}, rng))
    assert results[0] == results[1]


def test_a_lone_box_rests_where_it_was_dropped():
    item = box_item(1, "red box", (0.12, 0.08, 0.05))
    (placed,) = settle([item], {1: Drop(0.05, -0.1, UPRIGHT)}, np.random.default_rng(0))
    assert np.allclose(placed.pose.position, (0.05, -0.1, 0.0), atol=1e-3)
    assert np.allclose(np.abs(placed.pose.wxyz), UPRIGHT, atol=1e-3)


def test_everything_lies_within_the_picture():
    items, rng = few_items(), np.random.default_rng(3)
    drops = {item.instance: Drop(0.24, 0.24, UPRIGHT) for item in items}
    for item, placed in zip(items, settle(items, drops, rng), strict=True):
        corners = placed.pose.apply(item.body.pieces[0].vertices)
        assert np.abs(corners[:, :2]).max() <= UR5_TABLE.view_size / 2
        assert corners[:, 2].min() > -0.003


def test_what_cannot_stay_is_refused_by_name():
    table_wide = box_item(1, "long plank", (0.65, 0.05, 0.02))
    with pytest.raises(Unsatisfiable, match="long plank"):
        settle([table_wide], {1: Drop(0.0, 0.0, UPRIGHT)}, np.random.default_rng(0))
