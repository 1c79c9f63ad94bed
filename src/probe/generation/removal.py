"""Ghost removal: what shows of a scene once some things have vanished, frozen and re-settled."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from probe.generation.frame import SceneFrame
from probe.generation.result import Rejected
from probe.generation.scene_view import SceneView
from probe.generation.stage import Stage
from probe.generation.twins import Twin
from probe.generation.visibility_rules import HIDDEN_SHARE, LARGEST_GAIN, REVEALED_SHARE
from probe.scene.scene import Scene
from probe.scene.visibility import Visibility
from probe.tasks.truth import Silhouette, on_top
from probe.types import Array

_NOTABLE_PX = 100
"""An object that gains fewer pixels than this can't gain a fifth of its outline unnoticed."""


@dataclass(frozen=True, eq=False)
class GhostRemoval:
    """What is needed to take things away from scenes of a stage."""

    stage: Stage
    view: SceneView
    frame: SceneFrame

    def look(self, twin: Twin) -> RemovalView:
        """A first look at one scene."""
        return RemovalView(self, twin, self.view.labels(twin.scene))


@dataclass(frozen=True, eq=False)
class RemovedScene:
    """A scene without some things, and instance numbers of its picture, shape (h, w)."""

    scene: Scene
    labels: Array


@dataclass(frozen=True, eq=False)
class RemovalView:
    """What shows of a scene as it is, and of the same scene without some things.

    Attributes:
        labels: Instance numbers of the scene's picture, shape (h, w).
    """

    ghosts: GhostRemoval
    twin: Twin
    labels: Array

    @property
    def number_of(self) -> Mapping[int, int]:
        """The scene's number of each instance on the stage."""
        return self.ghosts.frame.number_of

    def before(self, of: Collection[int]) -> dict[int, Visibility]:
        """Visibility of some of the scene's instances."""
        return self.ghosts.view.visibility(self.twin.scene, self.labels, of)

    def with_what_lies_on(self, covering: int) -> tuple[int, ...]:
        """A cover and what lies on it: instances on the stage."""
        above = on_top(self.number_of[covering], self.silhouettes)
        return (covering, *(n for n in self.twin.poses if self.number_of[n] in above))

    @cached_property
    def silhouettes(self) -> Mapping[int, Silhouette]:
        """Of all that is on the table, by the scene's instances."""
        scene = self.twin.scene
        return self.ghosts.view.silhouettes(scene, [placed.instance for placed in scene.objects])

    def removals(self, removed: Collection[int]) -> Iterator[tuple[str, RemovedScene]]:
        """The scene without some of the stage's instances: "frozen", then "resettled"."""
        numbers = [self.number_of[instance] for instance in removed]
        yield "frozen", self._after(self.twin.scene.without(*numbers))
        lifted = self.ghosts.stage.lift(self.twin.poses, *removed)
        yield "resettled", self._after(self.ghosts.frame.scene(lifted))

    def share(self, after: RemovedScene, number: int) -> float:
        """Visible share of one of the scene's instances afterwards."""
        return self.ghosts.view.visibility(after.scene, after.labels, [number])[number].fraction

    def gains(self, after: RemovedScene, but: int) -> list[float]:
        """By how much the visible share of each other thing that shows more has grown."""
        size = int(max(self.labels.max(), after.labels.max())) + 1
        counts = [np.bincount(seen.ravel(), minlength=size) for seen in (after.labels, self.labels)]
        grown = np.nonzero(counts[0] - counts[1] > _NOTABLE_PX)[0]
        others = [int(number) for number in grown if number not in (0, but)]
        then = self.ghosts.view.visibility(after.scene, after.labels, others)
        first = self.before(others)
        return [then[number].fraction - first[number].fraction for number in others]

    def revealed(self, covering: int, target: int) -> dict[str, float]:
        """Visible shares without one thing; see revealed_without()."""
        return self.revealed_without([covering], target)

    def revealed_without(
        self, removed: Collection[int], target: int, still: Collection[int] = ()
    ) -> dict[str, float]:
        """Visible shares of what is hidden without what hides it, as a certificate names them.

        Args:
            removed: What hides it, instances on the stage.
            still: Instances of the scene that stay hidden then.
            target: What is hidden, an instance of the scene.

        Raises:
            Rejected: It is too little, or another thing comes into view as well.
        """
        measured: dict[str, float] = {}
        for how, after in self.removals(removed):
            measured[f"revealed_{how}"] = shown = self.share(after, target)
            if shown < REVEALED_SHARE:
                raise Rejected(f"revealed {how}", f"only {shown:.0%} show")
            too_much = max((self.share(after, number) for number in still), default=0.0)
            if too_much > HIDDEN_SHARE:
                raise Rejected(f"one tells {how}", f"{too_much:.0%} show of what lies deeper")
            gain = max(self.gains(after, but=target), default=0.0)
            if gain > LARGEST_GAIN:
                raise Rejected(f"others {how}", f"another gains {gain:.0%}")
        return measured

    def _after(self, scene: Scene) -> RemovedScene:
        return RemovedScene(scene, self.ghosts.view.labels(scene))
