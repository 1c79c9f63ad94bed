"""Which candidate stands behind the occluder, on scenes made by hand."""

from __future__ import annotations

import numpy as np
import pytest

from probe.question_types.behind.truth import which_behind
from probe.scene.scene import PlacedObject, Scene
from probe.scene.setup import UR5_TABLE
from probe.tasks.truth import Silhouette
from probe.types import Pose

CAMERA = UR5_TABLE.camera("front")
BOX, LIME, PLUM = 1, 2, 3


def scene(lime_y: float, plum_y: float) -> Scene:
    return Scene(
        0,
        "oak",
        (
            PlacedObject(BOX, "box", Pose((0.0, 0.0, 0.0))),
            PlacedObject(LIME, "lime", Pose((0.0, lime_y, 0.0))),
            PlacedObject(PLUM, "plum", Pose((0.0, plum_y, 0.0))),
        ),
    )


def strip(start: int, stop: int) -> Silhouette:
    mask = np.zeros((4, 100), dtype=bool)
    mask[1:3, start:stop] = True
    return Silhouette(mask, 0.05)


def found(lime_y: float, plum_y: float, lime: Silhouette, plum: Silhouette) -> str:
    shapes = {BOX: strip(10, 40), LIME: lime, PLUM: plum}
    table = scene(lime_y, plum_y)
    return which_behind(table, {"lime", "plum", "egg"}, BOX, shapes, CAMERA).object_id


def test_what_is_within_its_outline_and_farther_away_is_behind():
    assert found(0.1, 0.1, strip(20, 30), strip(60, 70)) == "lime"


def test_what_is_nearer_is_not_behind():
    assert found(0.1, -0.1, strip(20, 30), strip(20, 30)) == "lime"


@pytest.mark.parametrize(("start", "behind"), [(7, True), (6, False)])
def test_seven_tenths_of_its_outline_are_enough(start: int, behind: bool):
    lime = strip(start, start + 10)
    if behind:
        assert found(0.1, -0.1, lime, strip(60, 70)) == "lime"
    else:
        with pytest.raises(ValueError, match="not 0"):
            found(0.1, -0.1, lime, strip(60, 70))


def test_two_behind_it_are_ambiguous():
    with pytest.raises(ValueError, match="not 2"):
        found(0.1, 0.1, strip(20, 30), strip(20, 30))
