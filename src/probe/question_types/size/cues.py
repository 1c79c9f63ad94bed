"""What a picture with depth shows of Size's two things, and what is planned of that."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np

from probe.generation import depth_cues, size_cues
from probe.generation.depth_cues import DepthLook
from probe.generation.in_view import is_open
from probe.generation.marked import MarkedStage
from probe.generation.size_cues import VisiblePatch, Windows, are_within
from probe.generation.task_plan import CROSSED, MORE_CUES, PlannedProperty, TaskPlan
from probe.scene.scene import Scene
from probe.tasks.task import DEPTH_RULES
from probe.types import Array

DEPTH = PlannedProperty("depth", tuple(product((True, False), repeat=2)))
"""Whether the larger thing leads by the height of its cover, and by its own."""


def has_depth(plan: TaskPlan) -> bool:
    """Whether cues of depth are planned: by newer rules, where something is hidden."""
    return plan.rules >= DEPTH_RULES and not is_open(plan)


@dataclass(frozen=True)
class MarkedLook:
    """What shows of a marked thing; by rules that leave depth out, without it."""

    patch: VisiblePatch
    depth: DepthLook | None


@dataclass(frozen=True)
class PlannedCues:
    """By which of its cues the larger thing is to lead, and by how much either may.

    Attributes:
        a_is_larger: Whether that is A.
        signs: 1 where the larger thing leads, -1 where the smaller does: SizeCues and, by rules
            that know them, DepthCues.
        windows: Least and most of each.
    """

    a_is_larger: bool
    signs: Sequence[int]
    windows: Windows

    @staticmethod
    def of(plan: TaskPlan) -> PlannedCues:
        """A plan's."""
        cues, windows = (*CROSSED.of(plan)[1:], MORE_CUES.of(plan)[0]), [*size_cues.WINDOWS]
        if has_depth(plan):
            cues, windows = (*cues, *DEPTH.of(plan)), [*windows, *depth_cues.WINDOWS]
        a_is_larger = (plan.letter == "A") != (plan.form == "smaller")
        return PlannedCues(a_is_larger, [1 if cue else -1 for cue in cues], windows)

    @property
    def depth_signs(self) -> Sequence[int]:
        """Those of DepthCues alone; empty by rules that don't know them."""
        return self.signs[len(size_cues.WINDOWS) :]

    def goal(self, rng: np.random.Generator) -> list[float]:
        """Leads within the windows, drawn alike for every plan."""
        return [
            s * rng.uniform(*window) for s, window in zip(self.signs, self.windows, strict=True)
        ]

    def leads(self, a: MarkedLook, b: MarkedLook) -> dict[str, float]:
        """What the larger thing has over the smaller one, by name."""
        larger, smaller = (a, b) if self.a_is_larger else (b, a)
        size = size_cues.leads_of(larger.patch, smaller.patch)
        found = {f"{name}_lead": value for name, value in size._asdict().items()}
        if larger.depth and smaller.depth:
            depth = depth_cues.leads_of(larger.depth, smaller.depth)
            found |= {f"{name}_lead": value for name, value in depth._asdict().items()}
        return found

    def hold(self, a: MarkedLook, b: MarkedLook) -> bool:
        """Whether all lead as planned."""
        return are_within([*self.leads(a, b).values()], self.signs, self.windows)

    def off(self, a: MarkedLook, b: MarkedLook, goal: Sequence[float]) -> float:
        """How far what shows is from a goal; infinity where it isn't as planned."""
        leads = [*self.leads(a, b).values()]
        return math.dist(leads, goal) if are_within(leads, self.signs, self.windows) else math.inf


def shown_of(
    made: MarkedStage, plan: TaskPlan, scene: Scene, labels: Array, number: int
) -> MarkedLook:
    """What shows of a marked thing on a table; without depth where it lies open."""
    depth = DepthLook.of(made.view, scene, labels, number) if has_depth(plan) else None
    return MarkedLook(VisiblePatch.of(labels, number), depth)


def suits_depth(heights: Sequence[float], plan: TaskPlan, *, place: int) -> bool:
    """Whether heights that A and B will about have, metres, go with a plan.

    Args:
        heights: Of A and of B.
        plan: If it has no cues of depth, any do.
        place: Of which of the DepthCues.
    """
    cues = PlannedCues.of(plan)
    if not cues.depth_signs:
        return True
    larger, smaller = heights if cues.a_is_larger else reversed(heights)
    least, most = depth_cues.WINDOWS[place]
    return least <= cues.depth_signs[place] * math.log(larger / smaller) <= most
