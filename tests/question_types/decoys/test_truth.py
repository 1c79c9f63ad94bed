"""Which candidate lies under one of several like covers, on scenes made by hand."""

from __future__ import annotations

import numpy as np
import pytest

from probe.question_types.decoys.truth import which_under_any
from probe.scene.scene import PlacedObject, Scene
from probe.tasks.truth import Silhouette
from probe.types import Pose

COVERS = ONE, TWO, THREE = 1, 2, 3
LIME, PLUM, DIE = 4, 5, 6
NAMES = {ONE: "bowl", TWO: "bowl", THREE: "bowl", LIME: "lime", PLUM: "plum", DIE: "die"}
SCENE = Scene(0, "oak", tuple(PlacedObject(n, name, Pose()) for n, name in NAMES.items()))


def strip(start: int, stop: int, top: float) -> Silhouette:
    mask = np.zeros((4, 100), dtype=bool)
    mask[1:3, start:stop] = True
    return Silhouette(mask, top)


def found(lime: int, plum: int, top: float = 0.04) -> tuple[str, int]:
    """The answer with the two at these columns, a die under the first bowl."""
    shapes = {
        **{cover: strip(30 * place, 30 * place + 20, 0.06) for place, cover in enumerate(COVERS)},
        LIME: strip(lime, lime + 10, top),
        PLUM: strip(plum, plum + 10, 0.04),
        DIE: strip(5, 15, 0.04),
    }
    placed, cover = which_under_any(SCENE, {"lime", "plum", "egg"}, COVERS, shapes)
    return placed.object_id, cover


@pytest.mark.parametrize(("column", "cover"), [(5, ONE), (35, TWO), (65, THREE)])
def test_it_may_be_under_any_of_them(column: int, cover: int):
    assert found(lime=column, plum=88) == ("lime", cover)


def test_beside_them_or_above_them_none_is():
    with pytest.raises(ValueError, match="not 0"):
        found(lime=22, plum=88)
    with pytest.raises(ValueError, match="not 0"):
        found(lime=35, plum=88, top=0.07)


def test_two_under_two_of_them_are_ambiguous():
    with pytest.raises(ValueError, match="not 2"):
        found(lime=35, plum=65)
