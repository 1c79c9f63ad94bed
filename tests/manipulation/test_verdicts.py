"""What became of every way to grasp a thing, and that it is what the skill went by."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from functools import cache

import numpy as np
import pytest

from probe.manipulation.candidates import Grasp, propose
from probe.manipulation.grasp import PLANNERS
from probe.manipulation.pairs import around, opposed
from probe.manipulation.planning import GraspPlan, plan_grasp
from probe.manipulation.terrain import lifted
from probe.manipulation.verdicts import JudgedGrasp, judged
from probe.scene.setup import UR5_TABLE
from probe.station.ur5 import Ur5
from probe.types import Array, Pose
from tabletops import Block, PaintedStation

BOX = Block(1, (480, 420, 560, 580), 0.06)
NEIGHBOUR = Block(2, (590, 400, 680, 600), 0.10)


def planned(
    blocks: Sequence[Block], failed: Sequence[Grasp] = (), station: PaintedStation | None = None
) -> tuple[GraspPlan, list[JudgedGrasp]]:
    """How the first block would be grasped."""
    table = station or PaintedStation(blocks)
    frame = table.observe(rgb=False)
    assert frame.labels is not None
    plan = plan_grasp(table, frame, frame.labels == 1, UR5_TABLE, failed, PLANNERS)
    return plan, judged(plan, table.arm, table.hand)


@cache
def beside_a_neighbour() -> tuple[GraspPlan, list[JudgedGrasp]]:
    return planned((BOX, NEIGHBOUR))


def of(found: Sequence[JudgedGrasp], *verdicts: str) -> list[Grasp]:
    return [each.grasp for each in found if each.verdict in verdicts]


def test_one_is_chosen_and_it_is_the_plans() -> None:
    plan, found = beside_a_neighbour()
    assert plan.removal is not None
    assert of(found, "chosen") == [plan.removal.grasp]


def test_every_hand_that_was_thought_of_has_a_verdict() -> None:
    """As many as there are pairs of places and tilts, counted without the planner's choice."""
    plan, found = beside_a_neighbour()
    hand = PaintedStation([]).hand
    thought_of = len(around(opposed(plan.target, hand.max_opening - 0.006)).widths)
    refused = of(found, "touching", "no_hold", "unchecked")
    fit = len(found) - len(refused)
    # A box on the table has no edge that leans, and one of the hands across it has a route.
    assert fit == plan.candidates == len(propose(plan.target, plan.terrain, hand))
    # One hand may fit with more and with less room to spare, and is then two grasps.
    assert 0 < thought_of - len(refused) <= fit


def meets(grasp: Grasp, points: Array) -> bool:
    """Whether the open hand meets points anywhere on its last 10 cm, or closing, by its boxes."""
    hand = PaintedStation([]).hand
    local = grasp.hand.inverse().apply(points)
    states = [(grasp.opening, back) for back in np.linspace(0.0, 0.1, 11)]
    states += [(opening, 0.0) for opening in np.linspace(grasp.width, grasp.opening, 4)]
    return any(
        (np.abs(local + [0.0, 0.0, back] - centre) < half).all(axis=1).any()
        for opening, back in states
        for centre, half in hand.boxes(float(opening))
    )


def test_what_would_touch_something_does_by_the_hands_boxes() -> None:
    plan, found = beside_a_neighbour()
    frame = plan.frame
    assert frame.labels is not None
    seen = lifted(frame, np.ones(frame.depth.shape, bool), step=4)  # 2 mm apart.
    near = seen[np.linalg.norm(seen[:, :2] - plan.target.centre[:2], axis=1) < 0.2]
    # What shows from above is taken as solid down to the table.
    solid = np.concatenate([near * [1.0, 1.0, share] for share in (0.25, 0.5, 0.75, 1.0)])
    touching, (best,) = of(found, "touching"), of(found, "chosen")
    assert len(touching) > 100
    assert np.mean([meets(grasp, solid) for grasp in touching[::20]]) > 0.9
    # But for the box itself, which the pads close on.
    tall = plan.target.top[:, 2].max()
    assert not meets(best, solid[solid[:, 2] > tall + 0.005])


class Lame(Ur5):
    """An arm that reaches nothing."""

    def inverse(self, world_from_tool: Pose) -> list[Array]:
        return []


class Right(Ur5):
    """An arm that reaches nothing near the basket."""

    def inverse(self, world_from_tool: Pose) -> list[Array]:
        return super().inverse(world_from_tool) if world_from_tool.position[0] > -0.3 else []


def test_without_inverse_kinematics_all_that_were_tried_are_out_of_reach() -> None:
    station = PaintedStation((BOX, NEIGHBOUR))
    station.arm = Lame()
    plan, found = planned((), station=station)
    assert plan.removal is None and plan.lack == "unreachable"
    tried = sum(min(16, len(p(plan.target, plan.terrain, station.hand))) for p in PLANNERS)
    assert len(of(found, "out_of_reach")) == tried > 0
    assert of(found, "chosen", "no_way_in", "no_way_out") == []


def test_what_can_be_reached_but_not_brought_to_the_basket_has_no_way_out() -> None:
    station = PaintedStation((BOX, NEIGHBOUR))
    station.arm = Right()
    plan, found = planned((), station=station)
    assert plan.removal is None
    assert len(of(found, "no_way_out")) > 0 and of(found, "out_of_reach", "chosen") == []


def test_what_resembles_a_failed_one_is_spent_and_another_is_chosen() -> None:
    _, first = beside_a_neighbour()
    (best,) = of(first, "chosen")
    _, found = planned((BOX, NEIGHBOUR), failed=[best])
    like = [
        grasp
        for grasp in propose_all()
        if np.linalg.norm(np.subtract(grasp.middle, best.middle)) < 0.012
        and abs(grasp.hand.rotation[:, 1] @ best.hand.rotation[:, 1]) > np.cos(np.radians(25))
    ]
    assert Counter(of(found, "spent")) == Counter(like) and best in like
    (other,) = of(found, "chosen")
    assert other not in like


def propose_all() -> list[Grasp]:
    plan, _ = beside_a_neighbour()
    return propose(plan.target, plan.terrain, PaintedStation([]).hand)


def test_what_is_too_wide_and_flat_has_no_candidate_and_says_why() -> None:
    plan, found = planned((Block(1, (300, 300, 700, 700), 0.02),))
    assert plan.removal is None and plan.lack == "no_candidate"
    assert of(found, "chosen", "untried", "no_way_in", "no_way_out", "out_of_reach") == []


@pytest.mark.parametrize("number", [0, 3])
def test_the_same_view_gives_the_same_verdicts(number: int) -> None:
    plan, found = beside_a_neighbour()
    again = judged(plan, PaintedStation([]).arm, PaintedStation([]).hand)
    assert again[number::4] == found[number::4]
