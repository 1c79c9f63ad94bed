"""A finished scene on a stage of its own: as an episode finds it, without what built it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from probe.assets.library import Library
from probe.generation.stage import Poses, Stage
from probe.scene.scene import PlacedObject, Scene
from probe.types import Pose


@dataclass(frozen=True, eq=False)
class RestoredStage:
    """A scene and its physics; the stage numbers things from 1 in the scene's order."""

    scene: Scene
    stage: Stage

    @staticmethod
    def of(scene: Scene, library: Library) -> RestoredStage:
        """Build the stage."""
        specs = [library[placed.object_id] for placed in scene.objects]
        return RestoredStage(scene, Stage(specs, library, (), scene.setup))

    @property
    def poses(self) -> Poses:
        """Where all are."""
        return {n: placed.pose for n, placed in enumerate(self.scene.objects, start=1)}

    def places(self, *instances: int) -> list[int]:
        """The stage's numbers of some of the scene's."""
        numbers = [placed.instance for placed in self.scene.objects]
        return [1 + numbers.index(instance) for instance in instances]

    def moved(self, poses: Mapping[int, Pose]) -> Scene:
        """The scene with things elsewhere, and only those that have poses."""
        objects = tuple(
            PlacedObject(placed.instance, placed.object_id, poses[n])
            for n, placed in enumerate(self.scene.objects, start=1)
            if n in poses
        )
        return replace(self.scene, objects=objects)

    def unrest(self) -> str | None:
        """What is wrong with its rest, for people; None if nothing moves."""
        return self.stage.unrest(self.poses)
