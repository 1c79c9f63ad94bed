"""The rules that every scene of Behind keeps, whichever candidate is the hidden one."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from probe.generation.object_selection import ObjectSelection
from probe.generation.removal import GhostRemoval
from probe.generation.result import Rejected
from probe.generation.scene_view import SceneView
from probe.generation.twins import Twin, check_hidden
from probe.generation.visibility_rules import is_clear, is_hidden
from probe.question_types.behind.truth import which_behind
from probe.scene.scene import Scene
from probe.scene.visibility import Visibility


@dataclass(frozen=True, eq=False)
class Judge:
    """Checks the rules of Behind on one twin after the other and keeps what it measured.

    Attributes:
        cast: Who plays.
        ghosts: Take things away; they look from the task's camera.
        measures: By candidate.
    """

    cast: ObjectSelection
    ghosts: GhostRemoval
    measures: dict[int, Mapping[str, float]] = field(default_factory=dict[int, Mapping[str, float]])

    def check(self, twin: Twin) -> None:
        """All rules on one scene; cheap ones first.

        Raises:
            Rejected: It breaks one.
        """
        look, scene, view = self.ghosts.look(twin), twin.scene, self.ghosts.view
        target, occluder = look.number_of[1], look.number_of[self.cast.covering[0]]
        seen = look.before([target, occluder])
        check_hidden(seen[target])
        if not is_clear(seen[occluder]):
            raise Rejected("occluder unclear", f"only {seen[occluder].fraction:.0%} of it show")
        shapes = view.silhouettes(scene, [target, occluder])
        try:
            which_behind(scene, [scene[target].object_id], occluder, shapes, view.camera)
        except ValueError as failure:
            raise Rejected("behind", "its outline isn't within the occluder's") from failure
        if not is_hidden(alone := hidden_by(view, scene, target, occluder)):
            raise Rejected("hidden by others", f"{alone.fraction:.0%} show behind it alone")
        above = seen_from_above(view, scene, target)
        if not is_clear(above):
            raise Rejected("covered", f"only {above.fraction:.0%} show from above")
        self.measures[twin.candidate] = {
            "hidden_share": seen[target].fraction,
            "above_share": above.fraction,
            **look.revealed(self.cast.covering[0], target),
        }


def hidden_by(view: SceneView, scene: Scene, target: int, occluder: int) -> Visibility:
    """What shows of the target where only the two of them are on the table."""
    others = [it.instance for it in scene.objects if it.instance not in (target, occluder)]
    bare = scene.without(*others)
    return view.visibility(bare, view.labels(bare), [target])[target]


def seen_from_above(view: SceneView, scene: Scene, target: int) -> Visibility:
    """What the top camera would see of the target."""
    above = view.seen_from("top")
    return above.visibility(scene, above.labels(scene), [target])[target]
