"""Exact: take away what is named alone; other covers, which hide things as well, must stay."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

import numpy as np

from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.generation.covers import NEEDS_COVER, Cover
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
    draw_unlike_covers,
    select,
)
from probe.generation.task_generator import TaskGenerator
from probe.generation.task_plan import PlannedProperty, TaskPlan
from probe.generation.task_writer import Draft, write_task
from probe.generation.twins import draw_twins
from probe.render.renderer import Renderer
from probe.scene.seeds import generator
from probe.tasks.english import listed
from probe.tasks.truth import which_on_table

REMOVALS = PlannedProperty("removals", (1, 2))
"""How many of the covers are to be removed."""

_KEEP_OFF = 1.25
"""The hand comes down beside a cover, and nothing there may be moved."""

_FEWEST, _MOST = 4, 6
"""Things around the covers."""


def generate_exact(
    seed: int, plan: TaskPlan, library: Library, renderer: Renderer, tables: Sequence[str]
) -> TaskCandidate:
    """One attempt.

    Raises:
        Rejected: It failed a check.
    """
    rng = generator(seed, "exact")
    cast = select_exact(library, plan, rng)
    posts = draw_posts(cast.covers, _KEEP_OFF, rng)
    ghosts = set_up(cast, posts, seed, plan, library, renderer, tables, rng)
    stage, view, frame = ghosts.stage, ghosts.view, ghosts.frame
    removed = [int(number) for number in rng.permutation(COVERS)[: REMOVALS.of(plan)]]
    nests = Nests.built(cast, stage, posts, removed[0], rng)
    judge = NestsJudge(nests, ghosts)

    twins = draw_twins(cast, stage, partial(nests.nest, rng=rng), judge.check, frame, rng)
    true = cast.draw_true(rng)
    scene = twins[true].scene
    ids = [spec.id for spec in cast.candidates]
    target = which_on_table(scene, ids)
    order = [removed[int(index)] for index in rng.permutation(len(removed))]
    names = [cast.covers[number].spec.name for number in order]
    draft = Draft(
        question_type="exact",
        scene=scene,
        subject=", ".join(names),
        slots={"names": listed(names)},
        candidates=tuple(spec.name for spec in cast.candidates),
        truth=ids.index(target.object_id),
        targets=(target.instance,),
        named=tuple(frame.number_of[cast.covering[number]] for number in order),
        measures=judge.measures[true],
        drawn_from=tuple(ids),
    )
    task = with_necessary(write_task(draft, plan, view), view, library)
    return TaskCandidate(task, tuple(twin.scene for twin in twins))


def select_exact(library: Library, plan: TaskPlan, rng: np.random.Generator) -> ObjectSelection:
    """Three covers that the hand can lift, alike things beneath them, and a small crowd.

    Raises:
        Rejected: The library has no such set.
    """

    def draw(free: Sequence[ObjectSpec], hidden: Hidden) -> Sequence[Cover]:
        return draw_unlike_covers(library, free, hidden, rng)

    hide = partial(Hidden.drawn, rules=plan.rules)
    return select(library, draw, int(rng.integers(_FEWEST, _MOST + 1)), rng, hide)


GENERATOR = TaskGenerator(
    generate=generate_exact,
    select=select_exact,
    needs=f"{NEEDS_ALIKE}; over any of them, {COVERS} times, {NEEDS_COVER}, which can be lifted",
    turns=(REMOVALS,),
)
