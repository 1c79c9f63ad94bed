"""What lies beneath the thing beneath the cover, on scenes made by hand."""

from __future__ import annotations

import numpy as np
import pytest

from probe.question_types.nested.truth import which_nested
from probe.scene.scene import PlacedObject, Scene
from probe.tasks.truth import Silhouette
from probe.types import Pose

TRAY, BOWL, LIME, PLUM, BOOK = 1, 2, 3, 4, 5
NAMES = {TRAY: "tray", BOWL: "bowl", LIME: "lime", PLUM: "plum", BOOK: "book"}
SCENE = Scene(0, "oak", tuple(PlacedObject(n, name, Pose()) for n, name in NAMES.items()))


def strip(start: int, stop: int, top: float) -> Silhouette:
    mask = np.zeros((4, 100), dtype=bool)
    mask[1:3, start:stop] = True
    return Silhouette(mask, top)


def shapes(**other: Silhouette) -> dict[int, Silhouette]:
    """A tray over a bowl over a lime; a book over a plum beside them."""
    usual = {
        "tray": strip(10, 50, 0.08),
        "bowl": strip(20, 40, 0.06),
        "lime": strip(25, 35, 0.04),
        "plum": strip(70, 80, 0.04),
        "book": strip(65, 85, 0.06),
    }
    return {n: (usual | other)[name] for n, name in NAMES.items()}


def found(silhouettes: dict[int, Silhouette]) -> tuple[str, int]:
    placed, between = which_nested(SCENE, {"lime", "plum", "egg"}, TRAY, silhouettes)
    return placed.object_id, between


def test_it_is_what_lies_under_what_lies_under_the_cover():
    assert found(shapes()) == ("lime", BOWL)


def test_what_lies_right_under_the_cover_is_not_meant():
    with pytest.raises(ValueError, match="not 0"):
        found(shapes(lime=strip(41, 49, 0.04)))


def test_what_reaches_above_what_should_hide_it_does_not_lie_under_it():
    with pytest.raises(ValueError, match="not 0"):
        found(shapes(lime=strip(25, 35, 0.07)))


def test_two_at_the_bottom_are_ambiguous():
    with pytest.raises(ValueError, match="not 2"):
        found(shapes(plum=strip(22, 32, 0.04)))


def test_two_between_are_ambiguous():
    with pytest.raises(ValueError, match="not 2"):
        found(shapes(book=strip(20, 40, 0.07)))
