"""What can stand in front, and where."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from probe.assets.library import Library
from probe.generation.covers import Cover, Footprint
from probe.question_types.behind.lineup import Lineup
from probe.question_types.behind.occluders import draw_occluder
from probe.scene.seeds import generator
from probe.scene.setup import UR5_TABLE
from probe.types import Pose

SMALL = Footprint(0.05, 0.05)
CAMERA = UR5_TABLE.camera("front")


def standing(library: Library, object_id: str, item: Footprint = SMALL) -> Cover | None:
    return draw_occluder(library, [library[object_id]], [item], generator(0, "t"))


@pytest.mark.parametrize(
    "object_id", ["proc_green_cereal_box", "proc_tea_box", "proc_brick", "proc_orange_juice_carton"]
)
def test_it_stands_tall_with_its_wide_side_across(library: Library, object_id: str):
    occluder = standing(library, object_id)
    assert occluder is not None
    corners = Pose(wxyz=occluder.wxyz).apply(library.body(object_id).mesh.vertices)
    assert np.ptp(corners, axis=0) == pytest.approx(occluder.extent, abs=2e-3)
    wide, narrow, height = occluder.extent
    assert narrow <= wide and height == pytest.approx(max(library[object_id].size))


@pytest.mark.parametrize(
    "object_id",
    ["proc_red_folded_towel", "proc_red_tray", "proc_red_mug", "proc_gold_goblet"],
)
def test_what_would_fall_over_or_is_low_or_slim_is_none(library: Library, object_id: str):
    assert standing(library, object_id) is None


def test_it_is_wider_than_what_it_hides(library: Library):
    assert standing(library, "proc_orange_juice_carton", Footprint(0.068, 0.05)) is not None
    assert standing(library, "proc_orange_juice_carton", Footprint(0.07, 0.05)) is None


def test_the_three_stand_in_a_row_and_their_place_is_kept_free(library: Library):
    occluder = standing(library, "proc_green_cereal_box")
    assert occluder is not None
    rng = generator(3, "row")
    row = Lineup.drawn(CAMERA, occluder, [SMALL], rng)
    layer = row.layer(6, SMALL.width, rng)
    eye, stands = np.array(CAMERA.world_from_camera.position[:2]), row.place + layer.off
    to_front, to_target = stands - eye, row.place - eye
    assert np.cross([*to_front, 0], [*to_target, 0])[2] == pytest.approx(0, abs=1e-9)
    assert np.linalg.norm(to_front) < np.linalg.norm(to_target)
    # The two don't overlap, and lie in the first place that is kept free.
    assert np.linalg.norm(layer.off) >= (SMALL.width + occluder.extent[1]) / 2
    around = row.kept_free[0]
    for place, reach in ((stands, occluder.extent[1] / 2), (row.place, SMALL.width / 2)):
        assert np.hypot(*(place - (around.x, around.y))) + reach <= around.radius
    assert replace(row, room=0.06).middle.radius == 0.03
