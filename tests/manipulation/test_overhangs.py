from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from manipulation.views import Block, view
from probe.manipulation.overhangs import Overhangs, overhangs
from probe.manipulation.target import target_of
from probe.manipulation.terrain import survey
from probe.scene.setup import UR5_TABLE

STONE = Block(0.0, 0.0, (0.06, 0.06, 0.05))


def found(*blocks: Block) -> Overhangs:
    """Overhangs of the first block among the others."""
    frame, masks = view(blocks)
    terrain = survey(frame, UR5_TABLE)
    return overhangs(target_of(frame, masks[0], terrain), terrain)


@pytest.mark.parametrize("size", [(0.14, 0.18), (0.20, 0.10)])
@pytest.mark.parametrize("place", [(0.0, 0.0), (0.02, -0.03)])
def test_all_around_a_slab_its_edges_stand_out(size, place) -> None:
    slab = Block(place[0], place[1], (*size, 0.015), z=0.05)
    edges = found(slab, STONE)
    offset = edges.places[:, :2] - place
    beyond = np.abs(offset) - np.array(size) / 2
    assert beyond.max(axis=1) == pytest.approx(0.0, abs=0.006)
    assert edges.places[:, 2] == pytest.approx(0.065, abs=0.001)
    assert ((edges.outward[:, :2] * offset).sum(axis=1) > 0).all()
    assert edges.normals[:, 2] == pytest.approx(1.0, abs=0.01)
    for axis in (0, 1):
        for side in (-1, 1):
            assert (side * offset[:, axis] > size[axis] / 2 - 0.006).any()


def test_directions_are_unit_vectors_at_right_angles() -> None:
    edges = found(Block(0.0, 0.0, (0.14, 0.18, 0.015), z=0.05), STONE)
    assert np.linalg.norm(edges.outward, axis=1) == pytest.approx(1.0)
    assert (edges.outward * edges.normals).sum(axis=1) == pytest.approx(0.0, abs=1e-9)


def test_no_edge_stands_out_where_something_as_high_stands_beside_it() -> None:
    wall = Block(0.09, 0.0, (0.02, 0.30, 0.08))
    edges = found(Block(0.0, 0.0, (0.14, 0.18, 0.015), z=0.05), STONE, wall)
    assert len(edges.places)
    assert edges.places[:, 0].max() < 0.066


@pytest.mark.parametrize("height", [0.004, 0.012, 0.02])
def test_a_thin_thing_on_the_table_has_no_edge_that_stands_out(height) -> None:
    assert len(found(Block(0.0, 0.0, (0.16, 0.20, height))).places) == 0


def test_it_is_supposed_no_thicker_than_it_is_high_or_than_any_slab() -> None:
    assert found(Block(0.0, 0.0, (0.16, 0.20, 0.01), z=0.03)).thickness == pytest.approx(
        0.04, abs=0.001
    )
    assert found(Block(0.0, 0.0, (0.16, 0.20, 0.01), z=0.09)).thickness == 0.05


def test_a_leaning_slab_is_as_thick_as_its_low_end_shows() -> None:
    """A plane that rises 30 degrees from the table: its low end's upper corner shows."""
    thick, slope = 0.02, np.radians(30.0)
    frame, masks = view((Block(0.0, 0.0, (0.15, 0.12, 0.05)),))
    flat = survey(frame, UR5_TABLE)
    target = target_of(frame, masks[0], flat)
    rise = (target.top[:, 0] - target.top[:, 0].min()) * np.tan(slope) + thick * np.cos(slope)
    top = np.column_stack([target.top[:, :2], rise])
    rows, columns = flat.cells(top[:, :2])
    own, heights = target.heights.copy(), flat.heights.copy()
    own[rows, columns] = heights[rows, columns] = rise
    leaning = replace(target, heights=own, top=top)
    edges = overhangs(leaning, replace(flat, heights=heights))
    assert edges.leans
    assert edges.thickness == pytest.approx(thick, abs=0.0015)
    assert edges.outward[:, 0].max() == pytest.approx(np.cos(slope), abs=0.03)


def test_what_shows_of_a_side_is_no_edge() -> None:
    edges = found(Block(-0.2, 0.2, (0.14, 0.17, 0.024), z=0.05))
    assert len(edges.places)
    assert edges.places[:, 2] == pytest.approx(0.074, abs=0.002)
