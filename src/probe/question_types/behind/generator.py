"""Behind: what is behind a tall thing? Taking that away alone must tell, and looking must not."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from probe.assets.library import Library
from probe.generation.covers import Footprint, footprint_of
from probe.generation.frame import SceneFrame, frame_of
from probe.generation.likeness import TWIN_TOLERANCE, Likeness, whole_names_by
from probe.generation.object_selection import ObjectSelection, draw_cast, hideable, needs_alike
from probe.generation.removal import GhostRemoval
from probe.generation.result import Rejected, TaskCandidate
from probe.generation.scene_view import SceneView
from probe.generation.stage import Poses, Stage
from probe.generation.task_generator import TaskGenerator
from probe.generation.task_plan import TaskPlan
from probe.generation.task_writer import Draft, write_task
from probe.generation.twins import draw_twins
from probe.generation.visibility_rules import is_hidden
from probe.question_types.behind.judge import Judge
from probe.question_types.behind.lineup import Lineup
from probe.question_types.behind.occluders import NEEDS_OCCLUDER, draw_occluder
from probe.question_types.behind.truth import which_behind
from probe.render.renderer import Renderer
from probe.scene.seeds import generator

LARGEST = 0.07
"""Longest side in metres of what is hidden."""

_FEWEST, _MOST = 8, 11
_NEST_TRIES = 3


def generate_behind(
    seed: int, plan: TaskPlan, library: Library, renderer: Renderer, tables: Sequence[str]
) -> TaskCandidate:
    """One attempt.

    Raises:
        Rejected: It failed a check.
    """
    rng = generator(seed, "behind")
    cast = select_behind(library, plan, rng)
    view = SceneView(renderer, library, [spec.id for spec in cast.specs], plan.setup, "front")
    table = tables[int(rng.integers(len(tables)))]
    frame = frame_of(cast, seed, table, rng, plan.setup)
    row = Lineup.drawn(view.camera, cast.covers[0], _rooms(cast, library), rng)
    stage = Stage(cast.specs, library, row.kept_free, plan.setup)
    judge = Judge(cast, GhostRemoval(stage, view, frame))

    def nest(target: int) -> Poses:
        return _nest(cast, stage, row, view, frame, target, rng)

    twins = draw_twins(cast, stage, nest, judge.check, frame, rng)
    true = cast.draw_true(rng)
    scene, occluder = twins[true].scene, frame.number_of[cast.covering[0]]
    ids = [spec.id for spec in cast.candidates]
    shapes = view.silhouettes(scene, [frame.number_of[1], occluder])
    target = which_behind(scene, ids, occluder, shapes, view.camera)
    draft = Draft(
        question_type="behind",
        scene=scene,
        subject=cast.covers[0].spec.name,
        slots={"occluder": cast.covers[0].spec.name},
        candidates=tuple(spec.name for spec in cast.candidates),
        truth=ids.index(target.object_id),
        targets=(target.instance,),
        cover=occluder,
        measures=judge.measures[true],
        drawn_from=tuple(ids),
    )
    return TaskCandidate(write_task(draft, plan, view), tuple(twin.scene for twin in twins))


def select_behind(library: Library, plan: TaskPlan, rng: np.random.Generator) -> ObjectSelection:
    """Who plays; see draw_cast()."""
    count = int(rng.integers(_FEWEST, _MOST + 1))
    return draw_cast(
        library,
        hideable(library, LARGEST),
        draw_occluder,
        Likeness(TWIN_TOLERANCE, whole_names=whole_names_by(plan.rules)),
        rng,
        count,
    )


def _rooms(cast: ObjectSelection, library: Library) -> list[Footprint]:
    return [footprint_of(library, spec.id) for spec in cast.candidates]


def _nest(
    cast: ObjectSelection,
    stage: Stage,
    row: Lineup,
    view: SceneView,
    frame: SceneFrame,
    target: int,
    rng: np.random.Generator,
) -> Poses:
    """Stand the occluder before the target so that the camera doesn't see that.

    Raises:
        Rejected: It shows, or the two don't stand, whatever is tried.
    """
    (covering,), width = cast.covering, max(stage.items[target - 1].spec.size[:2])
    share = 0.0
    for _ in range(_NEST_TRIES):
        poses = stage.nest(target, [row.layer(covering, width, rng)], row.middle)
        scene, number = frame.scene(poses), frame.number_of[target]
        seen = view.visibility(scene, view.labels(scene), [number])[number]
        share = seen.fraction
        if is_hidden(seen) and not stage.jammed:
            return poses
    raise Rejected("nest", f"{cast.covers[0].spec.name} leaves {share:.0%} in view")


GENERATOR = TaskGenerator(
    generate=generate_behind,
    select=select_behind,
    needs=f"{needs_alike(LARGEST, TWIN_TOLERANCE)}; before any of them {NEEDS_OCCLUDER}",
)
