import sys
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from probe.assets.library import open_library
from probe.assets.tables import load_table, table_ids
from probe.errors import MissingExtra
from probe.perception.segmenter import Segmenter
from probe.render.photograph import load_scene, measure, photograph
from probe.render.renderer import Renderer
from probe.world.scenes import make_scene
from tabletops import Block, paint


def iou(one, other):
    return np.count_nonzero(one & other) / np.count_nonzero(one | other)


@settings(max_examples=6, deadline=None)
@given(
    st.lists(
        st.tuples(st.integers(30, 200), st.integers(30, 200), st.floats(0.01, 0.12)),
        min_size=4,
        max_size=4,
    )
)
def test_boxes_on_the_table_are_found_whole(sizes):
    corners = [(80, 80), (580, 80), (80, 580), (580, 580)]
    blocks = [
        Block(number, (u, v, u + wide, v + tall), height)
        for number, ((u, v), (wide, tall, height)) in enumerate(
            zip(corners, sizes, strict=True), start=1
        )
    ]
    frame, segmenter = paint(blocks), Segmenter()
    assert frame.labels is not None
    for block, (u, v) in zip(blocks, corners, strict=True):
        mask = segmenter.mask_at(frame, (u + 15, v + 15))
        assert mask is not None and iou(mask, frame.labels == block.instance) > 0.85
    things = segmenter.detect(frame)
    assert len(things) == 4
    assert [t.point_px[::-1] for t in things] == sorted(t.point_px[::-1] for t in things)
    assert all(t.mask[t.point_px[1], t.point_px[0]] and t.words.name is None for t in things)


def test_a_box_on_a_box_is_told_from_it_by_the_step_and_the_colour():
    lower = Block(1, (200, 200, 600, 600), height=0.04)
    upper = Block(2, (300, 300, 450, 420), height=0.09, colour=(30, 60, 160))
    frame = paint([lower, upper])
    assert frame.labels is not None
    for number, point in ((1, (550, 550)), (2, (380, 360))):
        mask = Segmenter().mask_at(frame, point)
        assert mask is not None and iou(mask, frame.labels == number) > 0.9


def test_labels_and_shares_play_no_part():
    frame = paint([Block(1, (200, 200, 400, 400)), Block(2, (500, 500, 600, 700))])
    bare = replace(frame, labels=None, shares=None)
    assert np.array_equal(Segmenter().numbers(frame), Segmenter().numbers(bare))


def test_the_table_is_nothing_and_a_near_miss_is_forgiven():
    frame, segmenter = paint([Block(1, (200, 200, 400, 400))]), Segmenter()
    assert segmenter.mask_at(frame, (800, 800)) is None
    assert segmenter.mask_at(frame, (430, 300)) is None
    assert segmenter.mask_at(frame, (405, 300)) is not None


def test_crumbs_are_no_things():
    assert Segmenter().detect(paint([Block(1, (200, 200, 208, 208))])) == ()


def test_it_looks_again_when_the_frame_is_another():
    segmenter = Segmenter()
    assert segmenter.mask_at(paint([Block(1, (200, 200, 400, 400))]), (300, 300)) is not None
    assert segmenter.mask_at(paint([]), (300, 300)) is None


def test_without_the_package_the_extra_is_named(monkeypatch):
    monkeypatch.setitem(sys.modules, "skimage.morphology", None)
    with pytest.raises(MissingExtra, match=r"'\.\[segment\]'"):
        Segmenter().detect(paint([Block(1, (200, 200, 400, 400))]))


@pytest.mark.slow
def test_objects_of_a_real_pile(assets, cache):
    """Far under what `benchmarks/internals/segmentation.py` finds: this is here to see it break."""
    things = open_library("scans", assets, cache)
    scene = make_scene(62_000, things, table_ids(assets))
    with Renderer() as renderer:
        load_scene(renderer, scene, things, load_table(scene.table, assets))
        frame, shown = photograph(renderer, scene), measure(renderer, scene)
    assert frame.labels is not None
    numbers, rng, found = Segmenter().numbers(frame), np.random.default_rng(0), list[float]()
    for instance, seen in shown.items():
        if seen.fraction >= 0.3 and seen.visible_px >= 400:
            truth = frame.labels == instance
            row, column = rng.choice(np.argwhere(truth))
            found.append(iou(numbers == numbers[row, column], truth))
    assert np.median(found) > 0.65
