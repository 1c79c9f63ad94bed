"""Find: which of these is on the table? It is hidden, or shows too little to be named."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from probe.assets.library import Library
from probe.generation.covers import NEEDS_COVER, NEEDS_LEAN, draw_cover, draw_lean
from probe.generation.frame import SceneFrame
from probe.generation.in_view import OPEN
from probe.generation.likeness import (
    LOOSE_TOLERANCE,
    TWIN_TOLERANCE,
    Likeness,
    sides_of,
    whole_names_by,
)
from probe.generation.object_selection import ObjectSelection, draw_cast, hideable, needs_alike
from probe.generation.result import Rejected, TaskCandidate
from probe.generation.scene_view import SceneView
from probe.generation.setting_up import set_up
from probe.generation.stage import Layer, Poses, Stage
from probe.generation.task_generator import TaskGenerator
from probe.generation.task_plan import PlannedProperty, TaskPlan
from probe.generation.task_writer import Draft, write_task
from probe.generation.toppings import TOPPED, is_topped, with_toppings
from probe.generation.twins import (
    Twin,
    build_nest,
    check_hidden,
    draw_post,
    draw_twins,
    right_above,
)
from probe.generation.visibility_rules import PARTLY, is_partly_visible
from probe.question_types.find.in_view import is_find_open, open_scene, with_secret
from probe.render.renderer import Renderer
from probe.scene.scene import Scene
from probe.scene.seeds import generator
from probe.scene.visibility import Visibility
from probe.tasks.truth import which_on_table
from probe.types import Array
from probe.world.model import Post

LARGEST_HIDDEN, LARGEST_PARTLY = 0.11, 0.16
"""Longest side of what is to be found, metres."""

_KEEP_OFF_HIDDEN, _KEEP_OFF_PARTLY = 0.8, 1.0
PARTLY_SEEN = PlannedProperty("partly", (False, False, True))
"""Whether the target is partly visible rather than hidden."""

_NEST_TRIES = 8
_NEST_WINDOW = (PARTLY[0], PARTLY[1] + 0.1)


def generate_find(
    seed: int, plan: TaskPlan, library: Library, renderer: Renderer, tables: Sequence[str]
) -> TaskCandidate:
    """One attempt.

    Raises:
        Rejected: It failed a check.
    """
    rng = generator(seed, "find")
    cast, partly = select_find(library, plan, rng), is_partly(plan)
    post = draw_post(cast.covers, _KEEP_OFF_PARTLY if partly else _KEEP_OFF_HIDDEN, rng)
    ghosts = set_up(cast, [post], seed, plan, library, renderer, tables, rng)
    stage, view, frame = ghosts.stage, ghosts.view, ghosts.frame
    if is_find_open(plan):
        scene, twins = open_scene(cast, stage, post, view, frame, rng), ()
    elif partly:
        scene, twins = _partly_scene(cast, stage, post, view, frame, rng), ()
    else:
        scene, twins = _hidden_scene(cast, stage, post, view, frame, rng)
    ids = [spec.id for spec in cast.candidates]
    target = which_on_table(scene, ids)
    seen = _seen(view, scene, target.instance)
    draft = Draft(
        question_type="find",
        scene=scene,
        subject="",
        slots={},
        candidates=tuple(spec.name for spec in cast.candidates),
        truth=ids.index(target.object_id),
        targets=(target.instance,),
        measures={"visible_share": seen.fraction, "partly": float(partly)},
        drawn_from=tuple(ids),
    )
    return TaskCandidate(write_task(draft, plan, view), twins)


def select_find(library: Library, plan: TaskPlan, rng: np.random.Generator) -> ObjectSelection:
    """Who plays; see draw_cast(). Where the target lies open, the cover hides something else.

    Raises:
        Rejected: The library has no such set.
    """
    whole = whole_names_by(plan.rules)
    if is_partly(plan):
        # A colour that shows would tell; so all candidates have it.
        return draw_cast(
            library,
            hideable(library, LARGEST_PARTLY),
            draw_lean,
            Likeness(LOOSE_TOLERANCE, one_colour=True, whole_names=whole),
            rng,
        )
    cast = draw_cast(
        library,
        hideable(library, LARGEST_HIDDEN),
        draw_cover,
        Likeness(TWIN_TOLERANCE, sides_of(plan.rules), whole_names=whole),
        rng,
    )
    if is_find_open(plan):
        return with_secret(library, cast, LARGEST_HIDDEN, rng)
    return with_toppings(library, cast, [0], rng) if is_topped(plan) else cast


def is_partly(plan: TaskPlan) -> bool:
    """Whether a little of the target shows."""
    return PARTLY_SEEN.of(plan) and not is_find_open(plan)


def _hidden_scene(
    cast: ObjectSelection,
    stage: Stage,
    post: Post,
    view: SceneView,
    frame: SceneFrame,
    rng: np.random.Generator,
) -> tuple[Scene, tuple[Scene, ...]]:
    """A scene that hides any of the candidates, and all its twins."""

    def check(twin: Twin) -> None:
        seen = _seen(view, twin.scene, frame.number_of[1])
        check_hidden(seen)

    lay = right_above(cast.covering[0], cast.covers[0])

    def nest(target: int) -> Poses:
        return build_nest(stage, target, lay, post, rng)

    twins = draw_twins(cast, stage, nest, check, frame, rng)
    return twins[cast.draw_true(rng)].scene, tuple(twin.scene for twin in twins)


def _partly_scene(
    cast: ObjectSelection,
    stage: Stage,
    post: Post,
    view: SceneView,
    frame: SceneFrame,
    rng: np.random.Generator,
) -> Scene:
    """A scene that leaves a little of one candidate to be seen."""
    target = 1 + cast.draw_true(rng)
    nest = _partly_nest(cast, stage, post, view, frame, target, rng)
    scene = frame.scene(stage.settle(stage.heap(nest, cast.crowd, rng)))
    seen = _seen(view, scene, frame.number_of[target])
    if not is_partly_visible(seen):
        raise Rejected("partly visible", f"{seen.fraction:.0%} show")
    return scene


def _partly_nest(
    cast: ObjectSelection,
    stage: Stage,
    post: Post,
    view: SceneView,
    frame: SceneFrame,
    target: int,
    rng: np.random.Generator,
) -> Poses:
    """Lay the cover beside the middle of the target until the right share of it shows."""
    size = stage.items[target - 1].spec.size
    (covering,), (cover,) = cast.covering, cast.covers
    share = 0.0
    for _ in range(_NEST_TRIES):
        turn, towards = rng.uniform(0, 2 * math.pi, size=2)
        distance = rng.uniform(0.1, 0.6) * min(*cover.extent[:2], 2 * max(size))
        off: Array = distance * np.array([np.cos(towards), np.sin(towards)])
        poses = stage.nest(target, [Layer(covering, cover, off, float(turn))], post)
        share = _seen(view, frame.scene(poses), frame.number_of[target]).fraction
        if _NEST_WINDOW[0] < share < _NEST_WINDOW[1]:
            return poses
    raise Rejected("nest", f"{cover.spec.name} leaves {share:.0%} in view")


def _seen(view: SceneView, scene: Scene, target: int) -> Visibility:
    return view.visibility(scene, view.labels(scene), [target])[target]


GENERATOR = TaskGenerator(
    generate=generate_find,
    select=select_find,
    needs=f"{needs_alike(LARGEST_HIDDEN, TWIN_TOLERANCE)}; "
    f"over any of them {NEEDS_COVER}. For every third task "
    f"{needs_alike(LARGEST_PARTLY, LOOSE_TOLERANCE)} but for the colour's name; "
    f"over any of them {NEEDS_LEAN}",
    turns=(PARTLY_SEEN, OPEN, TOPPED),
)
