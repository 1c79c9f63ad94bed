"""Beneath: what is under the cover? Lifting it alone must tell, and looking must not."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np

from probe.assets.library import Library
from probe.generation.covers import NEEDS_COVER, draw_cover
from probe.generation.likeness import TWIN_TOLERANCE, Likeness, sides_of, whole_names_by
from probe.generation.object_selection import (
    LARGEST,
    ObjectSelection,
    draw_cast,
    hideable,
    needs_alike,
)
from probe.generation.removal import GhostRemoval
from probe.generation.result import Rejected, TaskCandidate
from probe.generation.setting_up import set_up
from probe.generation.stage import Poses
from probe.generation.task_generator import TaskGenerator
from probe.generation.task_plan import TaskPlan
from probe.generation.task_writer import Draft, write_task
from probe.generation.toppings import TOPPED, is_topped, keep_off, with_toppings
from probe.generation.twins import (
    Twin,
    build_nest,
    check_hidden,
    draw_post,
    draw_twins,
    right_above,
)
from probe.generation.visibility_rules import is_seen
from probe.render.renderer import Renderer
from probe.scene.seeds import generator
from probe.tasks.task import PILE_RULES
from probe.tasks.truth import covered_share, lies_under, which_beneath

_KEEP_OFF = 1.05


def generate_beneath(
    seed: int, plan: TaskPlan, library: Library, renderer: Renderer, tables: Sequence[str]
) -> TaskCandidate:
    """One attempt.

    Raises:
        Rejected: It failed a check.
    """
    rng = generator(seed, "beneath")
    cast = select_beneath(library, plan, rng)
    post = draw_post(cast.covers, keep_off(plan, _KEEP_OFF), rng)
    ghosts = set_up(cast, [post], seed, plan, library, renderer, tables, rng)
    stage, view, frame = ghosts.stage, ghosts.view, ghosts.frame
    judge = _Judge(cast, ghosts, plan.rules >= PILE_RULES)
    lay = right_above(cast.covering[0], cast.covers[0])

    def nest(target: int) -> Poses:
        return build_nest(stage, target, lay, post, rng)

    twins = draw_twins(cast, stage, nest, judge.check, frame, rng)
    true = cast.draw_true(rng)
    scene, cover = twins[true].scene, frame.number_of[cast.covering[0]]
    ids = [spec.id for spec in cast.candidates]
    silhouettes = view.silhouettes(scene, [frame.number_of[1], cover])
    target = which_beneath(scene, ids, cover, silhouettes)
    draft = Draft(
        question_type="beneath",
        scene=scene,
        subject=cast.covers[0].spec.name,
        slots={"cover": cast.covers[0].spec.name},
        candidates=tuple(spec.name for spec in cast.candidates),
        truth=ids.index(target.object_id),
        targets=(target.instance,),
        cover=cover,
        measures=judge.measures[true],
        drawn_from=tuple(ids),
    )
    return TaskCandidate(write_task(draft, plan, view), tuple(twin.scene for twin in twins))


def select_beneath(library: Library, plan: TaskPlan, rng: np.random.Generator) -> ObjectSelection:
    """Who plays; see draw_cast() and with_toppings()."""
    whole = whole_names_by(plan.rules)
    likeness = Likeness(TWIN_TOLERANCE, sides_of(plan.rules), whole_names=whole)
    cast = draw_cast(
        library,
        hideable(library, LARGEST),
        draw_cover,
        likeness,
        rng,
    )
    return with_toppings(library, cast, [0], rng) if is_topped(plan) else cast


@dataclass(frozen=True, eq=False)
class _Judge:
    """Checks the rules of Beneath on one twin after the other and keeps what it measured."""

    cast: ObjectSelection
    ghosts: GhostRemoval
    piled: bool
    measures: dict[int, dict[str, float]] = field(default_factory=dict[int, dict[str, float]])

    def check(self, twin: Twin) -> None:
        """All rules on one scene; cheap ones first.

        Raises:
            Rejected: It breaks one.
        """
        look = self.ghosts.look(twin)
        target, cover = look.number_of[1], look.number_of[self.cast.covering[0]]
        seen = look.before([target, cover])
        check_hidden(seen[target])
        if not is_seen(seen[cover]):
            raise Rejected("cover unseen", f"{seen[cover].fraction:.0%} of the cover show")
        shapes = self.ghosts.view.silhouettes(twin.scene, [target, cover])
        share = covered_share(shapes[target], shapes[cover])
        if not lies_under(shapes[target], shapes[cover]):
            raise Rejected("under", f"{share:.0%} within the cover's outline")
        (covering,) = self.cast.covering
        gone = look.with_what_lies_on(covering) if self.piled else (covering,)
        self.measures[twin.candidate] = {
            "hidden_share": seen[target].fraction,
            "covered_share": share,
            **look.revealed_without(gone, target),
        }


GENERATOR = TaskGenerator(
    generate=generate_beneath,
    select=select_beneath,
    needs=f"{needs_alike(LARGEST, TWIN_TOLERANCE)}; over any of them {NEEDS_COVER}",
    turns=(TOPPED,),
)
