"""Budgeted: five covers, three manipulations, and a length for which two covers are too small."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import numpy as np

from probe.assets.library import Library
from probe.generation.edgewise_nests import EdgewiseNests
from probe.generation.likeness import longest
from probe.generation.necessary import with_necessary
from probe.generation.nests_judge import NestsJudge
from probe.generation.object_selection import ObjectSelection
from probe.generation.result import TaskCandidate
from probe.generation.scene_view import SceneView
from probe.generation.setting_up import set_up
from probe.generation.side_by_side import draw_posts
from probe.generation.task_generator import TaskGenerator
from probe.generation.task_plan import TaskPlan
from probe.generation.task_writer import Draft, write_task
from probe.generation.twins import draw_twins
from probe.question_types.budgeted.casting import NEEDS, select_budgeted
from probe.question_types.budgeted.judge import BudgetedJudge
from probe.question_types.budgeted.rules import MANIPULATIONS
from probe.question_types.budgeted.sizes import told_length, too_small
from probe.question_types.budgeted.truth import which_is_so_long
from probe.render.renderer import Renderer
from probe.scene.scene import Scene
from probe.scene.seeds import generator
from probe.tasks.english import listed

_KEEP_OFF = 1.1


def generate_budgeted(
    seed: int, plan: TaskPlan, library: Library, renderer: Renderer, tables: Sequence[str]
) -> TaskCandidate:
    """One attempt.

    Raises:
        Rejected: It failed a check.
    """
    rng = generator(seed, "budgeted")
    cast = select_budgeted(library, plan, rng)
    posts = draw_posts(cast.covers, _KEEP_OFF, rng)
    ghosts = set_up(cast, posts, seed, plan, library, renderer, tables, rng)
    stage, view, frame = ghosts.stage, ghosts.view, ghosts.frame
    places = _places(cast, library, rng)
    nests = EdgewiseNests(cast, stage, posts, places, [cast.secrets] * len(cast.candidates))
    judge = BudgetedJudge(NestsJudge(nests, ghosts), cast)

    twins = draw_twins(cast, stage, partial(nests.nest, rng=rng), judge.check, frame, rng)
    true = cast.draw_true(rng)
    covers = [frame.number_of[number] for number in cast.covering]
    draft = _draft(cast, twins[true].scene, covers, view, judge.base.measures[true])
    task = with_necessary(write_task(draft, plan, view), view, library)
    return TaskCandidate(task, tuple(twin.scene for twin in twins))


def _places(cast: ObjectSelection, library: Library, rng: np.random.Generator) -> Sequence[int]:
    """Which covers hide the candidates, the other short things and the tiny ones, in this order."""
    shortest = min(map(longest, cast.candidates))
    small = [n for n, it in enumerate(cast.covers) if too_small(library, it.spec.id, shortest)]
    order: list[int] = rng.permutation(len(cast.covers)).tolist()
    return [*(number for number in order if number not in small), *small]


def _draft(
    cast: ObjectSelection,
    scene: Scene,
    covers: Sequence[int],
    view: SceneView,
    measures: dict[str, float],
) -> Draft:
    """The task of a scene, without words and letters."""
    shapes = view.silhouettes(scene, [placed.instance for placed in scene.objects])
    lengths = {spec.id: longest(spec) for spec in cast.specs}
    sizes = [longest(spec) for spec in cast.candidates]
    target, cover = which_is_so_long(scene, covers, shapes, lengths, (min(sizes), max(sizes)))
    ids, names = [it.id for it in cast.candidates], [it.spec.name for it in cast.covers]
    return Draft(
        question_type="budgeted",
        scene=scene,
        subject=", ".join(names),
        slots={"covers": listed(names), "length": told_length(cast.candidates)},
        candidates=tuple(spec.name for spec in cast.candidates),
        truth=ids.index(target.object_id),
        targets=(target.instance,),
        cover=cover,
        measures=measures,
        drawn_from=tuple(ids),
        manipulations=MANIPULATIONS,
    )


GENERATOR = TaskGenerator(generate=generate_budgeted, select=select_budgeted, needs=NEEDS)
