"""What became of each way to grasp a thing that was thought of. Moves nothing, chooses nothing."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from probe.manipulation.candidates import Grasp
from probe.manipulation.kinematics import either_way, reaching
from probe.manipulation.planning import GraspPlan, PlannerTurn
from probe.manipulation.refused import refused
from probe.manipulation.removal import Route
from probe.station.station import Arm, Hand
from probe.types import Array

Verdict = Literal[
    "chosen",
    "untried",
    "spent",
    "no_way_out",
    "no_way_in",
    "out_of_reach",
    "touching",
    "no_hold",
    "unchecked",
]
"""How far a way to grasp something got:

chosen: It is carried out.
untried: It fits, but its paths weren't looked for: a better one has some, or 16 better ones have
    none.
spent: It resembles one that failed in the same call.
no_way_out: The arm can't lift the thing from there, or not to the basket.
no_way_in: The arm reaches it, but every path there meets something.
out_of_reach: No joint angles put the hand there.
touching, no_hold, unchecked: It is no grasp; see probe.manipulation.refused.
"""


@dataclass(frozen=True)
class JudgedGrasp:
    """A way to grasp something, and what became of it.

    Attributes:
        grasp: The hand; where the verdict is that it is no grasp, as far as it got.
        verdict: See Verdict.
    """

    grasp: Grasp
    verdict: Verdict


def judged(plan: GraspPlan, arm: Arm, hand: Hand) -> list[JudgedGrasp]:
    """All ways to grasp a plan's target that were thought of.

    What the plan keeps is taken from it; what its planners passed over is worked out again, by the
    same functions from the same values, and so it is what happened.

    Args:
        plan: Made by plan_grasp().
        arm: That it was made for.
        hand: That it was made for.
    """
    found: list[JudgedGrasp] = []
    for turn in plan.turns:
        found += _of_turn(turn, plan.start, arm)
        others = refused(turn.planner, plan.target, plan.terrain, hand)
        found += [JudgedGrasp(grasp, why) for grasp, why in others]
    return found


def _of_turn(turn: PlannerTurn, start: Array, arm: Arm) -> list[JudgedGrasp]:
    tried = [JudgedGrasp(route.grasp, _route_verdict(route, start, arm)) for route in turn.routes]
    untried = [JudgedGrasp(grasp, "untried") for grasp in turn.fresh[len(turn.routes) :]]
    return [*tried, *untried, *(JudgedGrasp(grasp, "spent") for grasp in turn.spent)]


def _route_verdict(route: Route, start: Array, arm: Arm) -> Verdict:
    if route.leave is not None:
        return "chosen"
    if route.enter is not None:
        return "no_way_out"
    ways = either_way(route.grasp.hand)
    return "no_way_in" if any(reaching(arm, pose, start) for pose in ways) else "out_of_reach"
