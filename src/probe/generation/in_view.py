"""Tasks that can be answered from the first picture: whoever always acts, acts needlessly."""

from __future__ import annotations

from collections.abc import Collection

from probe.generation.result import Rejected
from probe.generation.scene_view import SceneView
from probe.generation.task_plan import PlannedProperty, TaskPlan
from probe.generation.visibility_rules import is_clear, is_seen
from probe.scene.scene import Scene
from probe.tasks.task import OPEN_RULES

OPEN = PlannedProperty("open", (False, False, True))
"""Whether all that decides lies open, so that nothing needs to be moved."""

OPEN_QUARTER = PlannedProperty("open", (False, False, False, True))
"""The same, of types in which a quarter of the tasks does."""


def is_open(plan: TaskPlan, share: PlannedProperty[bool] = OPEN) -> bool:
    """Whether a plan asks for that; rules before OPEN_RULES never do.

    Args:
        plan: Of a type that is planned by `share`.
        share: OPEN or OPEN_QUARTER.
    """
    return plan.rules >= OPEN_RULES and share.of(plan)


def check_open(scene: Scene, view: SceneView, numbers: Collection[int]) -> None:
    """See that some instances are clear, and that perception names them.

    Raises:
        Rejected: One isn't.
    """
    shown = view.visibility(scene, view.labels(scene), numbers)
    for seen in shown.values():
        if not (is_clear(seen) and is_seen(seen)):
            raise Rejected("open", f"only {seen.fraction:.0%}, {seen.visible_px} px show")


def check_all_seen(scene: Scene, view: SceneView) -> None:
    """See that perception names everything on the table.

    Raises:
        Rejected: Something shows too little.
    """
    numbers = [placed.instance for placed in scene.objects]
    shown = view.visibility(scene, view.labels(scene), numbers)
    if unseen := sum(not is_seen(seen) for seen in shown.values()):
        raise Rejected("open", f"{unseen} things show too little to be named")
