"""Decoys: three like covers, and something under each. Which to lift first, nothing tells."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import numpy as np

from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.generation.covers import NEEDS_COVER, Cover, draw_cover
from probe.generation.necessary import with_necessary
from probe.generation.nests import Nests
from probe.generation.nests_judge import NestsJudge
from probe.generation.object_selection import ObjectSelection
from probe.generation.result import TaskCandidate
from probe.generation.setting_up import set_up
from probe.generation.side_by_side import (
    COVERS,
    NEEDS_ALIKE,
    Hidden,
    draw_posts,
    liftable,
    select,
)
from probe.generation.task_generator import TaskGenerator
from probe.generation.task_plan import TaskPlan
from probe.generation.task_writer import Draft, write_task
from probe.generation.toppings import TOPPED, is_topped, some_of, with_toppings
from probe.generation.twins import draw_twins
from probe.question_types.decoys.truth import which_under_any
from probe.render.renderer import Renderer
from probe.scene.seeds import generator
from probe.tasks.english import plural

_KEEP_OFF = 1.1
_FEWEST, _MOST = 5, 8
"""Things around the covers."""


def generate_decoys(
    seed: int, plan: TaskPlan, library: Library, renderer: Renderer, tables: Sequence[str]
) -> TaskCandidate:
    """One attempt.

    Raises:
        Rejected: It failed a check.
    """
    rng = generator(seed, "decoys")
    cast = select_decoys(library, plan, rng)
    posts = draw_posts(cast.covers, _KEEP_OFF, rng)
    ghosts = set_up(cast, posts, seed, plan, library, renderer, tables, rng)
    stage, view, frame = ghosts.stage, ghosts.view, ghosts.frame
    nests = Nests.built(cast, stage, posts, int(rng.integers(COVERS)), rng)
    judge = NestsJudge(nests, ghosts)

    twins = draw_twins(cast, stage, partial(nests.nest, rng=rng), judge.check, frame, rng)
    true = cast.draw_true(rng)
    scene = twins[true].scene
    ids = [spec.id for spec in cast.candidates]
    covers = [frame.number_of[number] for number in cast.covering]
    shapes = view.silhouettes(scene, [frame.number_of[1], *covers])
    target, cover = which_under_any(scene, ids, covers, shapes)
    name = cast.covers[0].spec.name
    draft = Draft(
        question_type="decoys",
        scene=scene,
        subject=name,
        slots={"covers": str(plural(name))},
        candidates=tuple(spec.name for spec in cast.candidates),
        truth=ids.index(target.object_id),
        targets=(target.instance,),
        cover=cover,
        measures=judge.measures[true],
        drawn_from=tuple(ids),
    )
    task = with_necessary(write_task(draft, plan, view), view, library)
    return TaskCandidate(task, tuple(twin.scene for twin in twins))


def select_decoys(library: Library, plan: TaskPlan, rng: np.random.Generator) -> ObjectSelection:
    """A cover three times, alike things to be beneath them, and a crowd.

    Raises:
        Rejected: The library has no such set.
    """

    def draw(free: Sequence[ObjectSpec], hidden: Hidden) -> Sequence[Cover]:
        countable = [spec for spec in liftable(free) if plural(spec.name)]
        cover = draw_cover(library, countable, hidden.room, rng)
        return [cover] * COVERS if cover else []

    hide = partial(Hidden.drawn, rules=plan.rules)
    cast = select(library, draw, int(rng.integers(_FEWEST, _MOST + 1)), rng, hide)
    return with_toppings(library, cast, some_of(COVERS, rng), rng) if is_topped(plan) else cast


GENERATOR = TaskGenerator(
    generate=generate_decoys,
    select=select_decoys,
    needs=f"{NEEDS_ALIKE}; over any of them {NEEDS_COVER}, which can be lifted and be counted",
    turns=(TOPPED,),
)
