"""Tries one tool on one target and asks the simulator what came of it."""

from __future__ import annotations

import contextlib
import math
import time
from collections.abc import Generator, Sequence

import numpy as np

from probe.assets.library import Library
from probe.episodes.arm_skills import ArmSkills
from probe.episodes.noise import Noise
from probe.manipulation.candidates import Planner
from probe.manipulation.grasp import PLANNERS
from probe.manipulation.push import ALONG, LONGEST, SHORTEST
from probe.render.renderer import Renderer
from probe.scene.scene import PlacedObject
from probe.station.simulated import SimulatedStation
from probe.station.station import Arm, Hand
from probe.tasks.grading import whereabouts
from probe.tool_bench.table import TrialTable
from probe.tool_bench.trial import Tool, ToolTrial
from probe.types import Array, Frame

MOVED = 0.03
"""Metres from which on another object counts as moved."""

_FELL_SHORT = 0.01


def attempt(
    tool: Tool,
    laid: TrialTable,
    target: PlacedObject,
    things: Library,
    renderer: Renderer,
    noise: Noise,
    planners: Sequence[Planner] = PLANNERS,
) -> ToolTrial:
    """Restore the table, try the tool, measure."""
    laid.world.restore(laid.start)
    station = _Timed(SimulatedStation(laid.world, renderer))
    skills = ArmSkills(noise, laid.scene.seed, 0, planners)
    trying = _grasp if tool == "grasp" else _push
    start = time.process_time()
    found = trying(skills, station, laid, target)
    spent = time.process_time() - start
    after, spec = laid.world.scene(), things[target.object_id]
    moved = [
        placed
        for placed in laid.scene.objects
        if placed.instance != target.instance
        and math.dist(placed.pose.position, after[placed.instance].pose.position) > MOVED
    ]
    lost = sum(whereabouts(after[o.instance].pose, after.setup) == "off the table" for o in moved)
    common: dict[str, object] = {
        "tool": tool,
        "seed": laid.scene.seed,
        "instance": target.instance,
        "object_id": target.object_id,
        "others_moved": len(moved),
        "others_lost": lost,
        "share": laid.share(target),
        "mass": spec.mass,
        "longest": max(spec.size),
        "planning": spent - station.seconds,
        "execution": station.seconds,
        "restless": laid.restless,
    }
    return ToolTrial.model_validate(common | found)


def _grasp(
    skills: ArmSkills, station: _Timed, laid: TrialTable, target: PlacedObject
) -> dict[str, object]:
    result = skills.grasp_and_remove(station, laid.frame, laid.mask(target), laid.scene.setup)
    inside = whereabouts(laid.world.scene()[target.instance].pose, laid.scene.setup) == "basket"
    return {
        "direction": None,
        "distance": None,
        "status": result.status,
        "good": inside,
        "executed": result.status == "removed",
        "truthful": inside == (result.status == "removed"),
        "ratio": None,
        "tries": result.tries,
        "width": result.width,
        "shoved": result.shove is not None,
    }


def _push(
    skills: ArmSkills, station: _Timed, laid: TrialTable, target: PlacedObject
) -> dict[str, object]:
    directions = list(ALONG)
    direction = directions[int(laid.rng.integers(len(directions)))]
    distance = float(laid.rng.uniform(SHORTEST, LONGEST))
    result = skills.push(
        station, laid.frame, laid.mask(target), direction, distance, laid.scene.setup
    )
    end = laid.world.scene()[target.instance].pose
    ratio = float(np.subtract(end.position, target.pose.position) @ ALONG[direction]) / distance
    reached = max(result.swept, result.moved or 0.0)
    return {
        "direction": direction,
        "distance": distance,
        "status": result.status,
        "good": ratio >= 0.5,
        "executed": reached > distance - _FELL_SHORT,
        "truthful": True,
        "ratio": ratio,
        "tries": result.strokes,
        "width": 0.0,
    }


class _Timed:
    """A Station that adds up the CPU seconds spent in it."""

    def __init__(self, station: SimulatedStation) -> None:
        self.arm: Arm = station.arm
        self.hand: Hand = station.hand
        self.seconds = 0.0
        self._station = station

    def observe(self, *, rgb: bool) -> Frame:
        with self._clock():
            return self._station.observe(rgb=rgb)

    def look_into_basket(self, *, rgb: bool) -> Frame:
        with self._clock():
            return self._station.look_into_basket(rgb=rgb)

    def joints(self) -> Array:
        return self._station.joints()

    def follow(self, path: Array) -> bool:
        with self._clock():
            return self._station.follow(path)

    def grip(self, opening: float) -> float:
        with self._clock():
            return self._station.grip(opening)

    def wait(self, seconds: float) -> None:
        with self._clock():
            self._station.wait(seconds)

    @contextlib.contextmanager
    def _clock(self) -> Generator[None]:
        start = time.process_time()
        yield
        self.seconds += time.process_time() - start
