"""Settled tables of real scans: pictures against a ray cast, and the same bytes anywhere."""

from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context

import numpy as np
import pytest

from observing import digest
from probe.assets.library import open_library
from probe.assets.tables import load_table, table_ids
from probe.render.photograph import load_scene, measure, photograph
from probe.scene.setup import UR5_TABLE
from probe.world.scenes import make_scene
from raycast import away_from_edges, cast

pytestmark = pytest.mark.slow

SEEDS = (3, 8)


@pytest.fixture(scope="module", params=SEEDS)
def tabletop(request, assets, cache, renderer):
    """A settled scene, loaded, and the meshes of its objects."""
    things = open_library("scans", assets, cache)
    scene = make_scene(request.param, things, table_ids(assets))
    load_scene(renderer, scene, things, load_table(scene.table, assets))
    return scene, {o.object_id: things.body(o.object_id).mesh for o in scene.objects}


def seen_and_cast(tabletop, renderer):
    scene, meshes = tabletop
    frame = photograph(renderer, scene, rgb=False)
    return frame, *cast(scene.objects, meshes, UR5_TABLE.camera(), UR5_TABLE.table_size)


def test_labels_and_depth_agree_with_a_ray_cast(tabletop, renderer):
    frame, labels, depth = seen_and_cast(tabletop, renderer)
    assert frame.labels is not None and frame.depth is not None
    on_objects = (labels > 0) | (frame.labels > 0)
    assert on_objects.sum() > 100_000
    assert (frame.labels == labels)[on_objects].mean() > 0.995
    # A fork is 3 mm thick: where it ends is an edge.
    flat = away_from_edges(depth, step=0.003)
    assert flat.mean() > 0.8
    assert np.abs(frame.depth - depth)[flat].max() < 1e-3


def test_visibility_by_ghost_removal_agrees_with_a_ray_cast(tabletop, renderer):
    scene, meshes = tabletop
    _, labels, _ = seen_and_cast(tabletop, renderer)
    measured = measure(renderer, scene)
    assert len(measured) == len(scene.objects) == 15
    for item in scene.objects:
        alone, _ = cast([item], meshes, UR5_TABLE.camera(), UR5_TABLE.table_size)
        expected = (labels == item.instance).sum() / (alone == item.instance).sum()
        assert measured[item.instance].fraction == pytest.approx(expected, abs=0.02)


def test_one_process_or_two_workers_the_same_bytes(assets, cache):
    seeds = (*SEEDS, 4)
    alone = [digest(seed, assets, cache) for seed in seeds]
    with ProcessPoolExecutor(2, mp_context=get_context("spawn")) as pool:
        others = list(pool.map(digest, seeds, [assets] * 3, [cache] * 3))
    assert alone == others
    assert len(set(alone)) == 3
