from __future__ import annotations

import numpy as np
import pytest

from bodies import at, box_item
from manipulation.standing import stand
from manipulation.views import Block, view
from probe.manipulation.candidates import Grasp
from probe.manipulation.edges import leaning, pinches, smallest_width
from probe.manipulation.handshape import HandShape
from probe.manipulation.overhangs import THICKNESS, overhangs
from probe.manipulation.target import target_of
from probe.manipulation.terrain import lifted, survey
from probe.render.renderer import Renderer
from probe.scene.setup import UR5_TABLE
from probe.station.gripper import Gripper
from probe.types import Array, Pose

HAND = Gripper()
SLAB = Block(0.0, 0.02, (0.14, 0.18, 0.015), z=0.1)
STONE = Block(0.0, 0.02, (0.03, 0.03, 0.1))


def grasps_of(*blocks: Block) -> list[Grasp]:
    """Edge grasps of the first block among the others."""
    frame, masks = view(blocks)
    terrain = survey(frame, UR5_TABLE)
    return pinches(target_of(frame, masks[0], terrain), terrain, HAND)


def thick_enough() -> list[Grasp]:
    """Edge grasps of the slab by which it is supposed at least as thick as it is."""
    found = [grasp for grasp in grasps_of(SLAB, STONE) if grasp.width >= SLAB.size[2]]
    assert found
    return found


def on_hand(grasp: Grasp, back: float) -> Array:
    """Points on the open hand when it is still so far back, world, shape (n, 3)."""
    shift = back * grasp.hand.rotation[:, 2]
    return grasp.hand.apply(HandShape(HAND).whole(grasp.opening)) - shift


@pytest.mark.parametrize("back", [0.0, 0.02, 0.05, 0.09])
def test_the_hand_comes_in_without_touching_the_slab_or_what_bears_it(back) -> None:
    for grasp in thick_enough():
        points = on_hand(grasp, back)
        for block in (SLAB, STONE):
            inside = ((points > block.low) & (points < block.high)).all(axis=1)
            assert not inside.any()
        assert (points[:, 2] > 0).all()


def test_one_pad_is_above_the_edge_and_one_below() -> None:
    for grasp in thick_enough():
        tips = grasp.hand.apply(HandShape(HAND).tips(grasp.opening))
        over = (np.abs(tips[:, :2] - [SLAB.x, SLAB.y]) < np.array(SLAB.size[:2]) / 2).all(axis=1)
        above, below = tips[:, 2] > SLAB.high[2], tips[:, 2] < SLAB.low[2]
        assert (above | below)[over].all()
        assert (over & above).any() and (over & below).any()
        assert grasp.opening < HAND.max_opening


def test_no_hand_meets_what_is_seen_beside_the_slab() -> None:
    blocks = (SLAB, STONE, Block(0.13, 0.0, (0.04, 0.30, 0.10)), Block(0.0, 0.2, (0.2, 0.04, 0.1)))
    frame, _ = view(blocks)
    seen = lifted(frame, np.ones(frame.depth.shape, bool), step=2)
    found = grasps_of(*blocks)
    assert found
    for grasp in found:
        local = grasp.hand.inverse().apply(seen)
        for centre, half in HAND.boxes(grasp.opening):
            assert not (np.abs(local - centre) < half).all(axis=1).any()


def test_the_best_come_first_and_the_same_view_gives_the_same() -> None:
    found, again = grasps_of(SLAB, STONE), grasps_of(SLAB, STONE)
    assert [g.merit for g in found] == sorted((g.merit for g in found), reverse=True)
    assert [g.hand for g in found] == [g.hand for g in again]


def test_what_lies_on_the_table_or_is_hemmed_in_has_none() -> None:
    assert grasps_of(Block(0.0, 0.0, (0.14, 0.18, 0.02))) == []
    fence = [
        Block(x, y, (0.14, 0.18, 0.15)) for x, y in ((-0.15, 0), (0.15, 0), (0, 0.2), (0, -0.16))
    ]
    assert grasps_of(SLAB, STONE, *fence) == []


def test_what_lies_level_may_be_a_block_and_isnt_pinched_first() -> None:
    frame, masks = view((SLAB, STONE))
    terrain = survey(frame, UR5_TABLE)
    assert leaning(target_of(frame, masks[0], terrain), terrain, HAND) == []


@pytest.mark.parametrize(("thickness", "pinched_first"), [(0.02, True), (0.06, False)])
def test_of_what_leans_only_a_slab_is_pinched_before_it_is_gripped_across(
    thickness: float, pinched_first: bool
) -> None:
    """A slab whose lower end lies on the table, and a thick block in the same place."""
    half = np.radians(9.0)
    turn = (np.cos(half), 0.0, np.sin(half), 0.0)
    thing = box_item(1, "red slab", (0.14, 0.10, thickness))
    stone = box_item(2, "green stone", (0.03, 0.08, 0.025))
    poses = [Pose((0.0, 0.0, 0.07 * np.sin(2 * half)), turn), at(-0.05, 0.0)]
    with Renderer() as renderer:
        station = stand(renderer, [thing, stone], poses)
        frame = station.observe(rgb=False)
    assert frame.labels is not None
    terrain = survey(frame, UR5_TABLE)
    target = target_of(frame, frame.labels == 1, terrain)
    edges = overhangs(target, terrain)
    assert edges.leans and edges.thickness == pytest.approx(min(thickness, 0.05), abs=0.005)
    assert bool(leaning(target, terrain, HAND)) == pinched_first
    assert pinches(target, terrain, HAND)


def test_a_tall_level_top_may_be_a_box_and_is_supposed_as_thick_as_any_slab() -> None:
    box = Block(0.0, 0.02, (0.14, 0.18, 0.09))
    assert all(grasp.width >= THICKNESS[1] for grasp in grasps_of(box))


def test_a_hand_turns_back_to_level_at_most() -> None:
    for grasp in thick_enough():
        assert 0 <= grasp.turn <= np.pi / 2 - grasp.tilt + 1e-9


def test_the_smallest_width_of_a_turned_rectangle_is_its_shorter_side() -> None:
    corners = np.array([[0.1, 0.05], [0.1, -0.05], [-0.1, 0.05], [-0.1, -0.05]])
    for angle in np.radians([0.0, 30.0, 70.0]):
        turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
        assert smallest_width(corners @ turn.T) == pytest.approx(0.10)
    assert smallest_width(np.zeros((0, 2))) == 0.0
