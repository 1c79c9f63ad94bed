"""Which thing under several covers has a length, on scenes made by hand."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pytest

from probe.question_types.budgeted.truth import which_is_so_long
from probe.scene.scene import PlacedObject, Scene
from probe.tasks.truth import Silhouette
from probe.types import Pose

COVERS = BOWL, MUG, POT = 1, 2, 3
PEN, KEY, DIE = 4, 5, 6
NAMES = {BOWL: "bowl", MUG: "mug", POT: "pot", PEN: "pen", KEY: "key", DIE: "die"}
SCENE = Scene(0, "oak", tuple(PlacedObject(n, name, Pose()) for n, name in NAMES.items()))


def strip(start: int, stop: int, top: float) -> Silhouette:
    mask = np.zeros((4, 100), dtype=bool)
    mask[1:3, start:stop] = True
    return Silhouette(mask, top)


def found(columns: Sequence[int], key: float = 0.06) -> tuple[str, int]:
    """What is 8.0 to 8.8 cm long, with the pen, the key and the die at these columns."""
    shapes = {
        **{cover: strip(30 * place, 30 * place + 20, 0.06) for place, cover in enumerate(COVERS)},
        **{n: strip(it, it + 10, 0.04) for n, it in zip((PEN, KEY, DIE), columns, strict=True)},
    }
    lengths = {"pen": 0.085, "key": key, "die": 0.02}
    placed, cover = which_is_so_long(SCENE, COVERS, shapes, lengths, (0.08, 0.088))
    return placed.object_id, cover


@pytest.mark.parametrize(("column", "cover"), [(5, BOWL), (35, MUG), (65, POT)])
def test_it_may_be_under_any_of_them(column: int, cover: int):
    others = sorted({5, 35, 65} - {column})
    assert found((column, *others)) == ("pen", cover)


def test_it_has_to_be_under_one_of_them():
    with pytest.raises(ValueError, match="not 0"):
        found((88, 5, 35))


@pytest.mark.parametrize(("key", "told"), [(0.083, "not 2"), (0.07, "1 more"), (0.09, "1 more")])
def test_nothing_else_there_is_nearly_so_long(key: float, told: str):
    with pytest.raises(ValueError, match=told):
        found((5, 35, 65), key)
