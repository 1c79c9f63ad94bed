"""How a grasp was chosen, in a recording: hands by verdict, the target's solid, planned paths."""

from __future__ import annotations

import numpy as np

from probe.film.recording.stream import Colour, RecordingWriter
from probe.film.recording.verdict_words import (
    VERDICT_LOOKS,
    counts_words,
    grasp_words,
    verdict_page,
)
from probe.manipulation.candidates import Grasp
from probe.manipulation.kinematics import between
from probe.manipulation.planning import GraspPlan
from probe.manipulation.removal import Removal
from probe.manipulation.verdicts import judged
from probe.station.station import Arm, Hand
from probe.types import Array

PLAN = "world/plan"
"""All that was thought of; one entity below it for each verdict."""

_TARGET: Colour = (90, 235, 235)
_STAGES: dict[str, Colour] = {
    "transit": (120, 200, 255),
    "approach": (40, 230, 90),
    "lift": (255, 230, 120),
    "carry": (255, 160, 60),
    "lower": (255, 90, 60),
}
_THICK, _THIN = 0.0022, 0.0005
_STEM = 0.03


def tell_plan(writer: RecordingWriter, plan: GraspPlan, heading: str, arm: Arm, hand: Hand) -> None:
    """All that a plan was made from, and what it says."""
    found = judged(plan, arm, hand)
    writer.clear(PLAN)
    for verdict, look in VERDICT_LOOKS.items():
        some = [each.grasp for each in found if each.verdict == verdict]
        if some:
            strips = [hand_outline(grasp, hand) for grasp in some]
            labels = [f"{look.words}; {grasp_words(grasp)}" for grasp in some]
            radius = _THICK if verdict == "chosen" else _THIN
            writer.lines(f"{PLAN}/{verdict}", strips, look.colour, radius, labels)
    writer.points(f"{PLAN}/target", plan.target.walls, _TARGET, _THIN)
    if plan.removal is not None:
        paths = planned_paths(plan.removal, plan.start, arm, hand)
        colours = [_STAGES[name] for name in paths]
        writer.lines(f"{PLAN}/path", list(paths.values()), colours, _THICK / 2, list(paths))
    writer.page("grasps", verdict_page(heading, found))
    level = "INFO" if plan.removal is not None else "WARN"
    writer.text(f"{heading}: {counts_words(found)}.", level)


def hand_outline(grasp: Grasp, hand: Hand) -> Array:
    """A hand on its way in as one line: along one pad, across, up and back, along the other.

    Returns:
        World, metres, shape (7, 3).
    """
    reach, half = hand.pad_reach(grasp.opening), grasp.opening / 2
    tip, root = reach + hand.pad_half[2], reach - hand.pad_half[2]
    left, right = ((0.0, sign * half, root) for sign in (-1.0, 1.0))
    middle, top = (0.0, 0.0, root), (0.0, 0.0, root - _STEM)
    ends = ((0.0, -half, tip), (0.0, half, tip))
    return grasp.hand.apply(np.array([ends[0], left, middle, top, middle, right, ends[1]]))


def planned_paths(removal: Removal, start: Array, arm: Arm, hand: Hand) -> dict[str, Array]:
    """Where the middle between the pads is to go, stage by stage; world, each of shape (k, 3)."""
    enter, leave = removal.enter, removal.leave
    stages = dict(
        zip(
            _STAGES,
            (enter.transit, enter.approach, leave.lift, leave.carry, leave.lower),
            strict=True,
        )
    )
    opening, last = removal.grasp.opening, start
    paths: dict[str, Array] = {}
    for name, joints in stages.items():
        if len(joints):
            path = between(np.vstack([last[None], joints]))
            paths[name] = np.array([pads_middle(arm, hand, angles, opening) for angles in path])
            last = joints[-1]
    return paths


def pads_middle(arm: Arm, hand: Hand, joints: Array, opening: float) -> Array:
    """The middle between pads so far apart, at joint angles of shape (n,); world, shape (3,)."""
    reach = hand.pad_reach(float(np.clip(opening, 0.0, hand.max_opening)))
    return arm.forward(joints).apply(np.array([[0.0, 0.0, reach]]))[0]
