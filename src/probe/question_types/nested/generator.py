"""Nested: what is under the thing under the cover? Only taking both away tells."""

from __future__ import annotations

from collections.abc import Sequence

from probe.assets.library import Library
from probe.generation.covers import NEEDS_COVER
from probe.generation.necessary import with_necessary
from probe.generation.result import TaskCandidate
from probe.generation.setting_up import set_up
from probe.generation.stage import Poses
from probe.generation.task_generator import TaskGenerator
from probe.generation.task_plan import TaskPlan
from probe.generation.task_writer import Draft, write_task
from probe.generation.toppings import TOPPED, keep_off
from probe.generation.twins import draw_post, draw_twins
from probe.question_types.nested.casting import NEEDS, select_nested
from probe.question_types.nested.judge import StackJudge
from probe.question_types.nested.stack import build_stack
from probe.question_types.nested.truth import which_nested
from probe.render.renderer import Renderer
from probe.scene.seeds import generator

_KEEP_OFF = 1.05


def generate_nested(
    seed: int, plan: TaskPlan, library: Library, renderer: Renderer, tables: Sequence[str]
) -> TaskCandidate:
    """One attempt.

    Raises:
        Rejected: It failed a check.
    """
    rng = generator(seed, "nested")
    cast = select_nested(library, plan, rng)
    post = draw_post(cast.covers, keep_off(plan, _KEEP_OFF), rng)
    ghosts = set_up(cast, [post], seed, plan, library, renderer, tables, rng)
    stage, view, frame = ghosts.stage, ghosts.view, ghosts.frame
    judge = StackJudge(cast, ghosts)

    def nest(target: int) -> Poses:
        return build_stack(cast, stage, target, post, rng)

    twins = draw_twins(cast, stage, nest, judge.check, frame, rng)
    true = cast.draw_true(rng)
    scene, outer = twins[true].scene, frame.number_of[cast.covering[1]]
    ids = [spec.id for spec in cast.candidates]
    shapes = view.silhouettes(scene, [placed.instance for placed in scene.objects])
    target, _ = which_nested(scene, ids, outer, shapes)
    name = cast.covers[1].spec.name
    draft = Draft(
        question_type="nested",
        scene=scene,
        subject=name,
        slots={"cover": name},
        candidates=tuple(spec.name for spec in cast.candidates),
        truth=ids.index(target.object_id),
        targets=(target.instance,),
        cover=outer,
        measures=judge.measures[true],
        drawn_from=tuple(ids),
    )
    task = with_necessary(write_task(draft, plan, view), view, library)
    return TaskCandidate(task, tuple(twin.scene for twin in twins))


GENERATOR = TaskGenerator(
    generate=generate_nested,
    select=select_nested,
    needs=f"{NEEDS}; over any of them {NEEDS_COVER}; and another such thing over both",
    turns=(TOPPED,),
)
