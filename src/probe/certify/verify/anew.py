"""A frozen task's table looked at anew: what shows, and what shows once things are gone."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from functools import cached_property

import numpy as np

from probe.assets.library import Library
from probe.certify.stage import Stage
from probe.certify.view import View
from probe.render.renderer import Renderer
from probe.scene.scene import PlacedObject, Scene
from probe.scene.visibility import Visibility
from probe.types import Array, Pose


class Anew:
    """Measures one scene; what was loaded in the renderer is replaced."""

    def __init__(self, scene: Scene, library: Library, renderer: Renderer) -> None:
        self.scene = scene
        self.library = library
        self.view = View(renderer, library, [placed.object_id for placed in scene.objects])

    @cached_property
    def stage(self) -> Stage:
        """Its physics; instances are numbered from 1 in the scene's order."""
        specs = [self.library[placed.object_id] for placed in self.scene.objects]
        return Stage(specs, self.library, ())

    @cached_property
    def labels(self) -> Array:
        """Instance numbers of the first picture, shape (h, w)."""
        return self.view.labels(self.scene)

    @cached_property
    def seen(self) -> Mapping[int, Visibility]:
        """Visibility of each object, by instance."""
        return self._visibility(self.scene, self.labels)

    def removals(self, gone: Collection[int]) -> Iterator[tuple[str, Mapping[int, Visibility]]]:
        """What shows of the rest without some instances: "frozen", then "resettled"."""
        frozen = self.scene.without(*gone)
        yield "frozen", self._visibility(frozen, self.view.labels(frozen))
        places = [self._place(number) for number in gone]
        settled = self._scene(self.stage.lift(self._poses(), *places))
        yield "resettled", self._visibility(settled, self.view.labels(settled))

    def creep(self) -> float:
        """How far anything moves while it is checked to be at rest, metres.

        Raises:
            Rejected: It isn't at rest at all.
        """
        before = self._poses()
        after = self.stage.settle(before)
        return max(
            float(np.abs(np.subtract(after[n].position, before[n].position)).max()) for n in before
        )

    def _place(self, instance: int) -> int:
        return 1 + [placed.instance for placed in self.scene.objects].index(instance)

    def _poses(self) -> dict[int, Pose]:
        return {n: placed.pose for n, placed in enumerate(self.scene.objects, start=1)}

    def _scene(self, poses: Mapping[int, Pose]) -> Scene:
        objects = tuple(
            PlacedObject(placed.instance, placed.object_id, poses[n])
            for n, placed in enumerate(self.scene.objects, start=1)
            if n in poses
        )
        return Scene(self.scene.seed, self.scene.table, objects)

    def _visibility(self, scene: Scene, labels: Array) -> Mapping[int, Visibility]:
        return self.view.visibility(scene, labels, [placed.instance for placed in scene.objects])
