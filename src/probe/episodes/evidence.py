"""What has to vanish from a table for a question's evidence to show: the rule of each type."""

from __future__ import annotations

from collections.abc import Callable, Collection
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from probe.perception.naming import SEEN_SHARE
from probe.render.photograph import labels_of
from probe.render.renderer import Renderer
from probe.scene.scene import Scene
from probe.tasks.task import Task
from probe.tasks.truth import ON_SHARE
from probe.types import Array, Camera

_HIDES_PX = 30
"""A thing hides another if it covers so many pixels of its outline."""


@dataclass(frozen=True)
class TableSight:
    """A starting table, and what a camera sees of it; the renderer has its objects loaded."""

    scene: Scene
    renderer: Renderer
    camera: Camera

    @cached_property
    def outlines(self) -> dict[int, Array]:
        """Where each object would show if it stood alone, bool, shape (h, w), by instance."""
        return self.renderer.outlines(self.scene.objects, self.camera)

    def labels(self, gone: Collection[int] = ()) -> Array:
        """Instance numbers of the picture without some instances, shape (h, w)."""
        return labels_of(self.renderer, self.scene.without(*gone), camera=self.camera)

    def over(
        self, wanted: Collection[int], kept: Collection[int], gone: Collection[int] = ()
    ) -> set[int]:
        """All that hides some of the wanted things, layer by layer; what is kept stays.

        Args:
            wanted: Instances that are to show.
            kept: Instances that don't vanish.
            gone: Instances that have vanished before.
        """
        found: set[int] = set()
        while True:
            labels = self.labels({*gone, *found})
            over = {
                int(number)
                for one in wanted
                for number, count in enumerate(np.bincount(labels[self.outlines[one]]))
                if count >= _HIDES_PX and number not in (0, one, *kept)
            }
            if not over:
                return found
            found |= over

    def on_top(self, gone: Collection[int]) -> set[int]:
        """What lies on things that are gone and would stay in the air, if the camera looks down.

        Half or more of its outline is within that of such a thing, and there it hides that.
        """
        return {
            item
            for below in gone
            for item in self.outlines
            if item not in gone and self._is_on(item, below)
        }

    def _is_on(self, item: int, below: int) -> bool:
        mask = self.outlines[item]
        both = mask & self.outlines[below]
        if not mask.any() or both.sum() < ON_SHARE * mask.sum():
            return False
        alone = self.labels([n for n in self.outlines if n not in (item, below)])
        return bool((alone[both] == item).mean() > 1 / 2)


@dataclass(frozen=True)
class OracleRule:
    """How a type's evidence comes to light; the part "oracle_view" of a question type.

    Attributes:
        vanishing: The instances that vanish.
    """

    vanishing: Callable[[Task, TableSight], set[int]]


def like_covers(task: Task, viewpoint: TableSight) -> set[int]:
    """All copies of the cover that a question names."""
    return set() if task.cover is None else set(task.scene.like(task.cover))


def all_named(task: Task, viewpoint: TableSight) -> set[int]:
    """All that a question wants removed."""
    return set(task.named)


def over_marked(task: Task, viewpoint: TableSight) -> set[int]:
    """All that lies over a marked thing."""
    return viewpoint.over(set(task.targets), set(task.targets))


def over_faint(task: Task, viewpoint: TableSight) -> set[int]:
    """All that hides anything of which too little shows; of what is asked for, nothing vanishes.

    So "none of them" is seen to be true as well.
    """
    kept = set(task.targets)
    gone = viewpoint.over(kept, kept)
    counts = np.bincount(viewpoint.labels().ravel(), minlength=max(viewpoint.outlines) + 1)
    # What can't be named comes to light.
    faint = {n for n, mask in viewpoint.outlines.items() if counts[n] < SEEN_SHARE * mask.sum()}
    return gone | viewpoint.over(faint - gone, kept | faint, gone)
