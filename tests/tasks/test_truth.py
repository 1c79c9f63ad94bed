from __future__ import annotations

import numpy as np
import pytest

from probe.scene.scene import PlacedObject, Scene
from probe.tasks.truth import (
    Extent,
    Silhouette,
    how_many,
    lies_on,
    lies_under,
    on_top,
    which_beneath,
    which_darker,
    which_like,
    which_on_table,
    which_size,
)
from probe.types import Pose


def scene_of(*object_ids: str) -> Scene:
    placed = [PlacedObject(n, id, Pose()) for n, id in enumerate(object_ids, start=1)]
    return Scene(0, "oak", tuple(placed))


def strip(start: int, stop: int, top: float) -> Silhouette:
    mask = np.zeros((4, 100), dtype=bool)
    mask[1:3, start:stop] = True
    return Silhouette(mask, top)


@pytest.mark.parametrize(("object_id", "number"), [("lime", 2), ("mug", 1), ("plum", 0)])
def test_how_many(object_id, number):
    assert how_many(scene_of("lime", "mug", "lime"), object_id) == number


def test_the_one_candidate_on_the_table_is_found():
    found = which_on_table(scene_of("mug", "plum", "book"), {"lime", "plum", "egg"})
    assert (found.instance, found.object_id) == (2, "plum")


@pytest.mark.parametrize("on_table", [("mug",), ("lime", "plum"), ("plum", "plum")])
def test_anything_but_one_is_ambiguous(on_table):
    with pytest.raises(ValueError, match="Exactly one"):
        which_on_table(scene_of(*on_table), {"lime", "plum"})


@pytest.mark.parametrize(
    ("item", "cover", "under"),
    [
        (strip(20, 30, 0.05), strip(10, 40, 0.08), True),
        (strip(20, 30, 0.08), strip(10, 40, 0.08), False),  # not lower
        (strip(3, 13, 0.05), strip(6, 40, 0.08), True),  # exactly 70 %
        (strip(2, 12, 0.05), strip(6, 40, 0.08), False),  # 60 %
        (strip(5, 5, 0.05), strip(6, 40, 0.08), False),  # nothing of it in the picture
    ],
)
def test_lies_under(item, cover, under):
    assert lies_under(item, cover) is under


@pytest.mark.parametrize(
    ("item", "cover", "on"),
    [
        (strip(20, 30, 0.09), strip(10, 40, 0.08), True),
        (strip(20, 30, 0.07), strip(10, 40, 0.08), False),  # not higher
        (strip(5, 15, 0.09), strip(10, 40, 0.08), True),  # exactly half
        (strip(4, 14, 0.09), strip(10, 40, 0.08), False),  # 40 %
    ],
)
def test_lies_on(item, cover, on):
    assert lies_on(item, cover) is on
    assert on_top(1, {1: cover, 2: item}) == ((2,) if on else ())


def test_beneath_names_the_candidate_under_the_cover_and_no_other():
    scene = scene_of("bowl", "lime", "mug")
    silhouettes = {1: strip(10, 40, 0.08), 2: strip(20, 30, 0.05)}
    assert which_beneath(scene, {"lime", "plum"}, 1, silhouettes).instance == 2
    beside = silhouettes | {2: strip(60, 70, 0.05)}
    with pytest.raises(ValueError, match="not 0"):
        which_beneath(scene, {"lime", "plum"}, 1, beside)


SMALL, LARGE = Extent(0.06, 0.002, 1e-4), Extent(0.12, 0.006, 4e-4)


@pytest.mark.parametrize(
    ("form", "a", "b", "letter"),
    [
        ("longer", LARGE, SMALL, "A"),
        ("longer", SMALL, LARGE, "B"),
        ("larger", SMALL, LARGE, "B"),
        ("smaller", SMALL, LARGE, "A"),
        ("smaller", LARGE, SMALL, "B"),
        # A pen is longer than a box that holds more.
        ("longer", Extent(0.15, 0.001, 1e-5), Extent(0.11, 0.01, 1e-3), "A"),
    ],
)
def test_size_goes_by_length_or_volume(form, a, b, letter):
    assert which_size(form, a, b) == letter


@pytest.mark.parametrize(
    ("form", "a", "b"),
    [
        ("longer", Extent(0.10, 0.004, 1e-4), Extent(0.12, 0.004, 1e-4)),
        ("larger", Extent(0.10, 0.004, 1e-4), Extent(0.12, 0.005, 1.9e-4)),
        ("larger", Extent(0.10, 0.004, 1e-4), Extent(0.09, 0.005, 4e-4)),
        ("smaller", Extent(0.10, 0.006, 1e-4), Extent(0.12, 0.005, 4e-4)),
    ],
)
def test_sizes_that_depend_on_the_measure_are_refused(form, a, b):
    with pytest.raises(ValueError, match="clearly"):
        which_size(form, a, b)


RED, BLUE, PINK = np.array([45.0, 60, 40]), np.array([30.0, 20, -60]), np.array([75.0, 30, 5])


def test_colours_go_by_the_likeness_of_main_colours():
    assert which_like(RED, BLUE, RED + 2) == "A"
    assert which_like(BLUE, RED, RED + 2) == "B"
    assert which_darker(PINK, BLUE) == "B" and which_darker(BLUE, PINK) == "A"


def test_colours_that_leave_doubt_are_refused():
    with pytest.raises(ValueError, match="too alike"):
        which_like(RED, RED + 3, RED)
    with pytest.raises(ValueError, match="like it"):
        which_like(RED, BLUE, np.array([60.0, -60, 60]))
    with pytest.raises(ValueError, match="darker"):
        which_darker(RED, RED - [10, 0, 0])
