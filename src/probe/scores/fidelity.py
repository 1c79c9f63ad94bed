"""Reduce: whether what was to be removed was removed, and nothing else. From poses alone."""

from __future__ import annotations

import math
from collections.abc import Collection
from dataclasses import dataclass

from probe.episodes.record import EpisodeRecord
from probe.scene.scene import PlacedObject, Scene
from probe.tasks.grading import whereabouts

MOVED = 0.03
"""Metres from which on an object that wasn't named counts as disturbed."""


@dataclass(frozen=True)
class Fidelity:
    """How an order to remove some objects was carried out.

    Attributes:
        precision: Share of what was removed that had been named; None if nothing was removed.
        recall: Share of what had been named that was removed; None if nothing had been named.
        exact: The named ones were removed, and nothing else.
        attempts_a_removal: Grasps carried out for each object removed; None if none was.
        others_disturbed: Objects, neither named nor removed, that ended over 3 cm from where
            they had been or fell off the table.
    """

    precision: float | None
    recall: float | None
    exact: bool
    attempts_a_removal: float | None
    others_disturbed: int


def fidelity(record: EpisodeRecord, named: Collection[int]) -> Fidelity:
    """Compare the table's start and end.

    *Removed* is what lies in the basket at the end; what fell off the table was moved, not removed.

    Args:
        record: What happened.
        named: Instances that were to be removed.
    """
    start, end = record.scenes[0], record.scenes[-1]
    removed = {o.instance for o in end.objects if whereabouts(o.pose, end.setup) == "basket"}
    wanted = set(named)
    others = [o for o in start.objects if o.instance not in wanted | removed]
    return Fidelity(
        precision=_share(removed & wanted, removed),
        recall=_share(removed & wanted, wanted),
        exact=removed == wanted,
        attempts_a_removal=_grasps(record) / len(removed) if removed else None,
        others_disturbed=sum(_disturbed(other, end) for other in others),
    )


def _share(part: set[int], whole: set[int]) -> float | None:
    return len(part) / len(whole) if whole else None


def _grasps(record: EpisodeRecord) -> int:
    grasps = [step for step in record.steps if step.call.name == "grasp_and_remove"]
    return sum(step.status in ("done", "failed") for step in grasps)


def _disturbed(before: PlacedObject, end: Scene) -> bool:
    after = end[before.instance]
    lost = whereabouts(after.pose, end.setup) == "off the table"
    return lost or math.dist(before.pose.position, after.pose.position) > MOVED
