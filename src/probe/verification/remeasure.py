"""A frozen task's table looked at anew: what shows, and what shows once things are gone."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from functools import cached_property

from probe.assets.library import Library
from probe.generation.restored_stage import RestoredStage
from probe.generation.result import Rejected
from probe.generation.scene_view import SceneView
from probe.generation.twin_worlds import CompareQuestion, look_at_open_worlds, look_at_worlds
from probe.render.photograph import load_scene
from probe.render.renderer import Renderer
from probe.scene.cameras import View
from probe.scene.scene import PlacedObject, Scene
from probe.scene.visibility import Visibility
from probe.tasks.truth import Silhouette
from probe.types import Array


class Remeasurement:
    """Measures one scene; what was loaded in the renderer is replaced."""

    def __init__(
        self, scene: Scene, library: Library, renderer: Renderer, camera: View = "top"
    ) -> None:
        self.scene = scene
        self.library = library
        self._renderer = renderer
        self.view = SceneView(
            renderer, library, [placed.object_id for placed in scene.objects], scene.setup, camera
        )

    @cached_property
    def restaged(self) -> RestoredStage:
        """Its physics."""
        return RestoredStage.of(self.scene, self.library)

    @cached_property
    def labels(self) -> Array:
        """Instance numbers of the first picture, shape (h, w)."""
        return self.view.labels(self.scene)

    @cached_property
    def seen(self) -> Mapping[int, Visibility]:
        """Visibility of each object, by instance."""
        return self._visibility(self.scene, self.labels)

    @cached_property
    def silhouettes(self) -> Mapping[int, Silhouette]:
        """Of all that is on the table, by instance."""
        return self.view.silhouettes(self.scene, [it.instance for it in self.scene.objects])

    def called(self, name: str) -> PlacedObject:
        """The first object of that name; names are shared in the catalogue, not on a table."""
        return next(o for o in self.scene.objects if self.library[o.object_id].name == name)

    def removals(self, gone: Collection[int]) -> Iterator[tuple[str, Mapping[int, Visibility]]]:
        """What shows of the rest without some instances: "frozen", then "resettled"."""
        frozen = self.scene.without(*gone)
        yield "frozen", self._visibility(frozen, self.view.labels(frozen))
        bare = self.restaged
        settled = bare.moved(bare.stage.lift(bare.poses, *bare.places(*gone)))
        yield "resettled", self._visibility(settled, self.view.labels(settled))

    def worlds(
        self, matter: CompareQuestion, right: int, *, lie_open: bool = False
    ) -> dict[str, float]:
        """Compare's two worlds in pictures; see look_at_worlds() and look_at_open_worlds()."""
        look = look_at_open_worlds if lie_open else look_at_worlds
        try:
            return look(matter, self.scene, self.labels, right, self.library, self._renderer)
        except Rejected:
            # It may be the other world that failed; other checks go on with this one.
            load_scene(self._renderer, self.scene, self.library)
            raise

    def _visibility(self, scene: Scene, labels: Array) -> Mapping[int, Visibility]:
        return self.view.visibility(scene, labels, [placed.instance for placed in scene.objects])
