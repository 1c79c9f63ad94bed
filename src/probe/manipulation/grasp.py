"""The skill that takes a thing off the table and puts it into the basket. Knows no names."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

from probe.manipulation.candidates import Grasp, Planner, propose
from probe.manipulation.edges import leaning, pinches
from probe.manipulation.handshape import HandShape
from probe.manipulation.looking import still_there
from probe.manipulation.planning import GraspPlan, plan_grasp
from probe.manipulation.recognition import found_again
from probe.manipulation.removal import remove
from probe.manipulation.shove import Shove, shove
from probe.scene.setup import Setup
from probe.station.colours import paintable
from probe.station.station import Station
from probe.types import Array, Frame

GraspStatus = Literal[
    "removed", "no_candidate", "unreachable", "blocked", "slipped", "dropped", "moved"
]
"""What came of an attempt:

removed: It was let go over the basket and its place is empty.
no_candidate: No two sides of it that the open fingers get around.
unreachable: The arm reaches none of the grasps without touching something.
blocked: Something stopped the arm; it is still there.
slipped: The fingers closed on nothing or on something else, or lost it while lifting; it is
    still there.
dropped: It was lost on the way to the basket.
moved: It isn't where it was, nor in the basket.
"""

TRIES = 5
"""Grasps that one attempt may execute."""

TRIES_BLOCKED = 3
"""Grasps after which no other follows where something stopped the arm: each may shift what did."""

PLANNERS: tuple[Planner, ...] = (leaning, propose, pinches)
"""Whose grasps are tried, the next one's where none of those before has a free route."""

_STAYED = 0.5


@dataclass(frozen=True, eq=False)
class GraspResult:
    """What came of a grasp.

    Attributes:
        status: See GraspStatus.
        frame: The table afterwards.
        candidates: Grasps that fitted, at the first try; after a push, at the first after it.
        tries: How many were executed.
        width: Distance of the pads that was planned for the last one, metres; 0 without one.
        tilt: Angle of the hand from straight down then, radians.
        merit: How good it looked.
        plans: How each grasp was chosen, and, where no further one was found, why.
        shove: The push that came first, because no grasp had a free route; None without one.
    """

    status: GraspStatus
    frame: Frame
    candidates: int
    tries: int
    width: float
    tilt: float
    merit: float
    plans: tuple[GraspPlan, ...] = ()
    shove: Shove | None = None


def grasp_and_remove(
    station: Station,
    frame: Frame,
    mask: Array,
    setup: Setup,
    planners: Sequence[Planner] = PLANNERS,
) -> GraspResult:
    """Grasp what a mask shows, lift it and let it go over the basket.

    A grasp that fails is followed by another one while the thing can still be found by its
    shape and colours; after one by an edge, only across it. Where no grasp has a free route, and
    only its neighbours can be the reason, the thing is pushed a little, once. The arm starts and
    ends parked; what it touches stays as physics leaves it.

    Args:
        station: The arm, camera and table.
        frame: The table as it is now.
        mask: Which pixels show the thing, bool, shape (h, w).
        setup: The table's; its basket is where the thing goes.
        planners: Propose the grasps; each is asked where those before have none with a free route.
    """
    result = _attempted(station, frame, mask, setup, planners)
    if result.tries:
        return result
    pushed = shove(station, result.plans[0], mask, setup)
    if pushed is None:
        return result
    if pushed.mask is None:
        return replace(result, status="moved", frame=pushed.frame, shove=pushed)
    again = _attempted(station, pushed.frame, pushed.mask, setup, planners)
    return replace(again, plans=(*result.plans, *again.plans), shove=pushed)


def _attempted(
    station: Station, frame: Frame, mask: Array, setup: Setup, planners: Sequence[Planner]
) -> GraspResult:
    """One grasp after the other, until one has worked or no other is worth a try."""
    result = GraspResult("no_candidate", frame, 0, 0, 0.0, 0.0, 0.0)
    failed: list[Grasp] = []
    shape = HandShape(station.hand)
    while _goes_on(result):
        plan = plan_grasp(station, frame, mask, setup, failed, planners)
        removal, result = plan.removal, replace(result, plans=(*result.plans, plan))
        if not failed:
            result = replace(result, status=plan.lack, candidates=plan.candidates)
        if removal is None:
            break
        before = paintable(station, frame)
        done = remove(station, removal, shape)
        after = station.observe(rgb=False)
        stayed = still_there(frame, after, mask)
        failed.append(removal.grasp)
        result = replace(
            result,
            status=_judged(done, stayed),
            frame=after,
            tries=len(failed),
            width=removal.grasp.width,
            tilt=removal.grasp.tilt,
            merit=removal.grasp.merit,
        )
        if result.status in ("removed", "dropped"):
            break
        frame, found = found_again(station, before, after, mask)
        result = replace(result, frame=frame)
        if found is None:
            break
        mask = found.mask
    return result


def _goes_on(result: GraspResult) -> bool:
    """Whether another try is allowed."""
    return result.tries < (TRIES_BLOCKED if result.status == "blocked" else TRIES)


def _judged(done: GraspStatus, stayed: float) -> GraspStatus:
    """The outcome as felt by the hand, corrected by what is seen."""
    if done == "removed":
        return "slipped" if stayed > _STAYED else "removed"
    if done in ("blocked", "slipped") and stayed < _STAYED:
        return "moved"
    return done
