"""Beneath: what is under the cover? Lifting it alone must tell, and looking must not."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from probe.assets.library import Library
from probe.certify.alike import TWIN_TOLERANCE
from probe.certify.cast import LARGEST, Cast, draw_cast
from probe.certify.covers import draw_cover
from probe.certify.frame import SceneFrame, frame_of
from probe.certify.hiding import Twin, draw_post, draw_twins
from probe.certify.plan import Plan
from probe.certify.result import Candidate, Rejected
from probe.certify.rules import LARGEST_GAIN, REVEALED_SHARE, is_hidden, is_seen
from probe.certify.stage import Stage
from probe.certify.view import View
from probe.certify.writing import Draft, write_task
from probe.render.renderer import Renderer
from probe.scene.scene import Scene
from probe.scene.seeds import generator
from probe.tasks.truth import covered_share, lies_under, which_beneath
from probe.types import Array

_KEEP_OFF = 1.05
_NOTABLE_PX = 100
"""An object that gains fewer pixels than this can't gain a fifth of its outline unnoticed."""


def generate_beneath(
    seed: int, plan: Plan, library: Library, renderer: Renderer, tables: Sequence[str]
) -> Candidate:
    """One attempt.

    Raises:
        Rejected: It failed a check.
    """
    rng = generator(seed, "beneath")
    cast = draw_cast(library, draw_cover, LARGEST, TWIN_TOLERANCE, rng)
    post = draw_post(cast.cover, _KEEP_OFF, rng)
    stage = Stage(cast.specs, library, [post])
    view = View(renderer, library, [spec.id for spec in cast.specs])
    frame = frame_of(cast, seed, tables[int(rng.integers(len(tables)))], rng)
    judge = _Judge(cast, stage, view, frame)
    twins = draw_twins(cast, stage, post, judge.check, frame, rng)
    true = int(rng.integers(len(twins)))
    scene, cover = twins[true].scene, frame.number_of[cast.covering]
    ids = [spec.id for spec in cast.candidates]
    silhouettes = view.silhouettes(scene, [frame.number_of[1], cover])
    target = which_beneath(scene, ids, cover, silhouettes)
    draft = Draft(
        kind="beneath",
        scene=scene,
        subject=cast.cover.spec.name,
        slots={"cover": cast.cover.spec.name},
        candidates=tuple(spec.name for spec in cast.candidates),
        truth=ids.index(target.object_id),
        targets=(target.instance,),
        cover=cover,
        measures=judge.measures[true],
        drawn_from=tuple(ids),
    )
    return Candidate(write_task(draft, plan, view), tuple(twin.scene for twin in twins))


@dataclass(frozen=True, eq=False)
class _Judge:
    """Checks the rules of Beneath on one twin after the other and keeps what it measured."""

    cast: Cast
    stage: Stage
    view: View
    frame: SceneFrame
    measures: dict[int, dict[str, float]] = field(default_factory=dict[int, dict[str, float]])

    def check(self, twin: Twin) -> None:
        """All rules on one scene; cheap ones first.

        Raises:
            Rejected: It breaks one.
        """
        target, cover = self.frame.number_of[1], self.frame.number_of[self.cast.covering]
        labels = self.view.labels(twin.scene)
        seen = self.view.visibility(twin.scene, labels, [target, cover])
        if not is_hidden(seen[target]):
            raise Rejected("hidden", f"{seen[target].fraction:.0%}, {seen[target].visible_px} px")
        if not is_seen(seen[cover]):
            raise Rejected("cover unseen", f"{seen[cover].fraction:.0%} of the cover show")
        shapes = self.view.silhouettes(twin.scene, [target, cover])
        share = covered_share(shapes[target], shapes[cover])
        if not lies_under(shapes[target], shapes[cover]):
            raise Rejected("under", f"{share:.0%} within the cover's outline")
        frozen = self._revealed(twin, labels, twin.scene.without(cover), "frozen")
        lifted = self.frame.scene(self.stage.lift(twin.poses, self.cast.covering))
        settled = self._revealed(twin, labels, lifted, "re-settled")
        self.measures[twin.candidate] = {
            "hidden_share": seen[target].fraction,
            "covered_share": share,
            "revealed_frozen": frozen,
            "revealed_resettled": settled,
        }

    def _revealed(self, twin: Twin, before: Array, after: Scene, how: str) -> float:
        """Visible share of the target without the cover; nothing else may come to light."""
        target = self.frame.number_of[1]
        labels = self.view.labels(after)
        share = self.view.visibility(after, labels, [target])[target].fraction
        if share < REVEALED_SHARE:
            raise Rejected(f"revealed {how}", f"only {share:.0%} show")
        size = max(before.max(), labels.max()) + 1
        gained = np.bincount(labels.ravel(), minlength=size) - np.bincount(
            before.ravel(), minlength=size
        )
        others = [int(n) for n in np.nonzero(gained > _NOTABLE_PX)[0] if n not in (0, target)]
        then = self.view.visibility(after, labels, others)
        first = self.view.visibility(twin.scene, before, others)
        gains = [then[n].fraction - first[n].fraction for n in others]
        if max(gains, default=0.0) > LARGEST_GAIN:
            raise Rejected(f"others {how}", f"another gains {max(gains):.0%}")
        return share
