"""Pictures that show a task's evidence by ghost removal, for models that have no tools.

Each task gets two pictures, the first one and one from which things have vanished, whatever its
answer: their number tells nothing. Nothing is moved, so that marks keep their places.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

from probe.assets.library import Library
from probe.episodes.evidence import OracleRule, TableSight
from probe.render.lighting import light_of
from probe.render.photograph import load_scene, photograph
from probe.render.renderer import Renderer
from probe.scene.viewpoint import Viewpoint
from probe.tasks.marks import drawn
from probe.tasks.registry import part_of
from probe.tasks.task import PILE_RULES, Task
from probe.types import Camera, Frame


@dataclass(frozen=True, eq=False)
class OracleView:
    """What a model of the setting "oracle-view" is shown.

    Attributes:
        first: The table at the start, marks drawn on it.
        revealed: The same without what hides the evidence; without marks.
        removed: Instances that have vanished from it.
    """

    first: Frame
    revealed: Frame
    removed: tuple[int, ...]

    @property
    def frames(self) -> tuple[Frame, Frame]:
        """Both pictures, in the order in which they are shown."""
        return self.first, self.revealed


def oracle_view(
    task: Task, library: Library, renderer: Renderer, viewpoint: Viewpoint | None = None
) -> OracleView:
    """Draw a task's evidence, as it was made or seen otherwise; replaces what was loaded before."""
    viewpoint = viewpoint or task.viewpoint
    load_scene(renderer, task.scene, library)
    light = light_of(viewpoint.lighting, library.assets)
    first = photograph(renderer, task.scene, camera=viewpoint.camera, light=light)
    assert first.rgb is not None
    removed = tuple(sorted(vanishing(task, renderer, viewpoint.camera)))
    rest = task.scene.without(*removed)
    return OracleView(
        replace(first, rgb=drawn(first.rgb, task.marks)),
        photograph(renderer, rest, camera=viewpoint.camera, light=light),
        removed,
    )


def vanishing(task: Task, renderer: Renderer, camera: Camera | None = None) -> set[int]:
    """Instances without which a task's evidence shows; the renderer must have them loaded."""
    rule = part_of(task.question_type, "oracle_view", OracleRule)
    sight = TableSight(task.scene, renderer, camera or task.viewpoint.camera)
    gone = rule.vanishing(task, sight)
    if task.version < PILE_RULES:
        return gone
    # What lies on what is a matter of the view from above, whichever camera shows the task.
    above = TableSight(task.scene, renderer, task.setup.camera("top"))
    return gone | (above.on_top(gone) - set(task.targets))
