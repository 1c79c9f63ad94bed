"""Pictures that show a task's evidence by ghost removal, for models that have no tools.

Each task gets two pictures, the first one and one from which things have vanished, whatever its
answer: their number tells nothing. Nothing is moved, so that marks keep their places.
"""

from __future__ import annotations

from collections.abc import Callable, Collection
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from probe.assets.library import Library
from probe.perception.oracle import SEEN_SHARE
from probe.render.lighting import light_of
from probe.render.photograph import labels_of, load_scene, photograph
from probe.render.renderer import Renderer
from probe.scene.layout import top_camera
from probe.scene.scene import Scene
from probe.scene.viewpoint import Viewpoint
from probe.tasks.marks import drawn
from probe.tasks.task import Task
from probe.types import Array, Camera, Frame

_HIDES_PX = 30
"""A thing hides another if it covers so many pixels of its outline."""


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
    task: Task, library: Library, renderer: Renderer, sight: Viewpoint | None = None
) -> OracleView:
    """Draw a task's evidence, as always or in another sight; replaces what was loaded before."""
    sight = sight or Viewpoint()
    load_scene(renderer, task.scene, library, library.table(task.scene.table))
    light = light_of(sight.lighting, library.assets)
    first = photograph(renderer, task.scene, camera=sight.camera, light=light)
    assert first.rgb is not None
    removed = tuple(sorted(vanishing(task, renderer, sight.camera)))
    rest = task.scene.without(*removed)
    return OracleView(
        replace(first, rgb=drawn(first.rgb, task.marks)),
        photograph(renderer, rest, camera=sight.camera, light=light),
        removed,
    )


def vanishing(task: Task, renderer: Renderer, camera: Camera | None = None) -> set[int]:
    """Instances without which a task's evidence shows; the renderer must have them loaded.

    Beneath: the cover. Reduce: what is named. Compare and Size: all that lies over a marked thing.
    Find and Count: all that hides anything of which too little shows, so that "none of them" is
    seen to be true as well; of what is asked for, nothing vanishes.
    """
    if task.cover is not None:
        return {task.cover}
    if task.named:
        return set(task.named)
    outlines = renderer.outlines(task.scene.objects, camera or top_camera())
    see = partial(labels_of, renderer, camera=camera)
    if task.marks:
        return _over(task.scene, set(task.targets), set(task.targets), outlines, see)
    kept = set(task.targets)
    gone = _over(task.scene, kept, kept, outlines, see)
    counts = np.bincount(see(task.scene).ravel(), minlength=max(outlines) + 1)
    # What can't be named comes to light in Find and Count.
    faint = {n for n, mask in outlines.items() if counts[n] < SEEN_SHARE * mask.sum()}
    return gone | _over(task.scene.without(*gone), faint - gone, kept | faint, outlines, see)


def _over(
    scene: Scene,
    wanted: Collection[int],
    kept: Collection[int],
    outlines: dict[int, Array],
    see: Callable[[Scene], Array],
) -> set[int]:
    """All that hides some of the wanted things, layer by layer; what is kept stays."""
    gone: set[int] = set()
    while True:
        labels = see(scene.without(*gone))
        over = {
            int(number)
            for one in wanted
            for number, count in enumerate(np.bincount(labels[outlines[one]]))
            if count >= _HIDES_PX and number not in (0, one, *kept)
        }
        if not over:
            return gone
        gone |= over
