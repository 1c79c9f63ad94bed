"""Relation: three like covers in a ring. What lies under the next after that of a named thing?"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from probe.assets.library import Library
from probe.generation.bystanders import draw_bystanders
from probe.generation.covers import NEEDS_COVER
from probe.generation.edgewise_nests import EdgewiseNests
from probe.generation.necessary import with_necessary
from probe.generation.nests_judge import NestsJudge
from probe.generation.object_selection import ObjectSelection
from probe.generation.result import Rejected, TaskCandidate
from probe.generation.scene_view import SceneView
from probe.generation.setting_up import set_up
from probe.generation.side_by_side import draw_posts
from probe.generation.task_generator import TaskGenerator
from probe.generation.task_plan import TaskPlan
from probe.generation.task_writer import Draft, write_task
from probe.generation.toppings import TOPPED
from probe.generation.twins import Twin, draw_twins
from probe.question_types.relation.casting import NEEDS, select_relation
from probe.question_types.relation.rules import RULES
from probe.question_types.relation.truth import clockwise, next_along, next_beneath
from probe.render.renderer import Renderer
from probe.scene.scene import PlacedObject, Scene
from probe.scene.seeds import generator
from probe.tasks.english import plural
from probe.world.model import Post

_KEEP_OFF = 1.1


def generate_relation(
    seed: int, plan: TaskPlan, library: Library, renderer: Renderer, tables: Sequence[str]
) -> TaskCandidate:
    """One attempt.

    Raises:
        Rejected: It failed a check.
    """
    rng = generator(seed, "relation")
    cast = select_relation(library, plan, rng)
    posts = draw_posts(cast.covers, _KEEP_OFF, rng)
    # Two candidates lie on the table, so that each needs a number of its own.
    ghosts = set_up(cast, posts, seed, plan, library, renderer, tables, rng, apart=True)
    stage, view, frame = ghosts.stage, ghosts.view, ghosts.frame
    (named,) = cast.secrets
    beside = [(named, other + 1) for (other,) in draw_bystanders(RULES.bystanders, rng)]
    nests = EdgewiseNests(cast, stage, posts, _places(posts, plan, rng), beside)
    base = NestsJudge(nests, ghosts)
    covers = [frame.number_of[number] for number in cast.covering]
    ring = _Ring(plan, view, frame.number_of[named], covers)

    def check(twin: Twin) -> None:
        base.check(twin)
        expected = frame.number_of[twin.candidate + 1]
        if (found := ring.answer(twin.scene)[0].instance) != expected:
            raise Rejected("ring", f"{found} lies under the next cover, not {expected}")

    twins = draw_twins(cast, stage, partial(nests.nest, rng=rng), check, frame, rng)
    true = cast.draw_true(rng)
    draft = _draft(cast, ring, twins[true].scene, base.measures[true])
    task = with_necessary(write_task(draft, plan, view), view, library)
    return TaskCandidate(task, tuple(twin.scene for twin in twins))


def _places(posts: Sequence[Post], plan: TaskPlan, rng: np.random.Generator) -> list[int]:
    """Covers, by number, of a candidate, of the named thing, and of the candidate beside it."""
    at = np.array([(post.x, post.y, 0.0) for post in posts])
    points = plan.setup.camera().project(at).tolist()
    order = clockwise({number: (u, v) for number, (u, v) in enumerate(points)})
    named = int(rng.integers(len(posts)))
    asked = next_along(plan.form, order, named)
    return [asked, named, next(n for n in order if n not in (asked, named))]


@dataclass(frozen=True, eq=False)
class _Ring:
    """Says what is under the next cover.

    Attributes:
        plan: Says which way round.
        view: Sees the covers.
        named: Instance of the thing that the question names.
        covers: Instances.
    """

    plan: TaskPlan
    view: SceneView
    named: int
    covers: Sequence[int]

    def answer(self, scene: Scene) -> tuple[PlacedObject, int]:
        """What is under the next cover, and that cover.

        Raises:
            Rejected: The covers don't stand in a ring, each over one thing.
        """
        shapes = self.view.silhouettes(scene, [placed.instance for placed in scene.objects])
        try:
            return next_beneath(scene, self.plan.form, self.named, self.covers, shapes)
        except ValueError as failure:
            raise Rejected("ring", str(failure)) from failure


def _draft(cast: ObjectSelection, ring: _Ring, scene: Scene, measures: dict[str, float]) -> Draft:
    """The task of a scene, without words and letters."""
    target, cover = ring.answer(scene)
    ids, name = [spec.id for spec in cast.candidates], cast.covers[0].spec.name
    return Draft(
        question_type="relation",
        scene=scene,
        subject=name,
        slots={"covers": str(plural(name)), "name": cast.beneath[0].name},
        candidates=tuple(spec.name for spec in cast.candidates),
        truth=ids.index(target.object_id),
        targets=(target.instance, ring.named),
        cover=cover,
        measures=measures,
        drawn_from=tuple(ids),
    )


GENERATOR = TaskGenerator(
    generate=generate_relation,
    select=select_relation,
    needs=f"{NEEDS}; over any of them {NEEDS_COVER}, which can be lifted and be counted",
    turns=(TOPPED,),
)
