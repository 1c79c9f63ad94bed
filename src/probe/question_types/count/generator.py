"""Count: how many are there? Some lie open, some beneath things, none in between."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np

from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.generation.alike import draw_alike, unlike
from probe.generation.covers import NEEDS_COVER, Cover, Footprint, draw_cover, footprint_of
from probe.generation.frame import SceneFrame
from probe.generation.in_view import OPEN, check_all_seen, is_open
from probe.generation.likeness import LOOSE_TOLERANCE, Likeness, sides_of
from probe.generation.object_selection import (
    CAST_TRIES,
    LARGEST,
    LEADING,
    draw_crowd,
    hideable,
    needs_alike,
)
from probe.generation.result import Rejected, TaskCandidate
from probe.generation.scene_view import SceneView
from probe.generation.stage import Poses, Stage
from probe.generation.task_generator import TaskGenerator
from probe.generation.task_plan import PlannedProperty, TaskPlan
from probe.generation.task_writer import Draft, write_task
from probe.generation.toppings import TOPPED, draw_toppings, is_topped, keep_off, some_of
from probe.generation.twins import build_nest, check_toppings, right_above
from probe.generation.visibility_rules import is_clear, is_hidden
from probe.render.renderer import Renderer
from probe.scene.scene import Scene
from probe.scene.seeds import generator
from probe.tasks.english import plural
from probe.tasks.options import MOST_HIDDEN, count_candidates
from probe.tasks.task import SIX_RULES
from probe.tasks.truth import how_many
from probe.types import Array
from probe.world.model import Post

NESTS = MOST_HIDDEN
"""Things hidden beneath others in every scene; those that aren't counted are there as decoys, so
that a suspicious cover tells nothing."""

INSTANCES = PlannedProperty("count", tuple(product(range(4), range(NESTS + 1))))
"""How many instances are clear, and how many hidden, by rules before SIX_RULES."""

TO_SIX = PlannedProperty("count to six", tuple(product(range(5), range(NESTS + 1))))
"""The same since then."""

_FEWEST, _MOST = 12, 15
_FROM_MIDDLE = 0.11
_KEEP_OFF = 1.05


@dataclass(frozen=True, eq=False)
class _Cast:
    """Who plays: what is beneath each cover, the covers, the crowd, and the open instances.

    The last of the crowd lie on covers: `topped` are these, by number from 0.
    """

    counted: ObjectSpec
    beneath: tuple[ObjectSpec, ...]
    covers: tuple[Cover, ...]
    crowd: tuple[ObjectSpec, ...]
    open: int
    topped: tuple[int, ...] = ()

    @property
    def toppings(self) -> Mapping[int, int]:
        """What lies on covers, and on which: instances on the stage."""
        end = len(self.beneath) + len(self.covers) + len(self.crowd)
        under = (len(self.beneath) + 1 + number for number in self.topped)
        return dict(zip(range(end - len(self.topped) + 1, end + 1), under, strict=True))

    @property
    def specs(self) -> tuple[ObjectSpec, ...]:
        """All of them, in the order of their instances on the stage."""
        covers = [cover.spec for cover in self.covers]
        return (*self.beneath, *covers, *self.crowd, *[self.counted] * self.open)


def generate_count(
    seed: int, plan: TaskPlan, library: Library, renderer: Renderer, tables: Sequence[str]
) -> TaskCandidate:
    """One attempt.

    Raises:
        Rejected: It failed a check.
    """
    rng = generator(seed, "count")
    visible, hidden_ones = instances(plan)
    cast = select_count(library, plan, rng)
    posts = [] if is_open(plan) else _draw_posts(cast.covers, keep_off(plan, _KEEP_OFF), rng)
    stage = Stage(cast.specs, library, posts, plan.setup)
    table = tables[int(rng.integers(len(tables)))]
    frame = SceneFrame.of(cast.specs, seed, table, rng, plan.setup)
    scene = frame.scene(_settle(cast, stage, posts, rng))
    view = SceneView(renderer, library, frame.ids.values(), plan.setup)
    hidden = [frame.number_of[number] for number in range(1, len(cast.beneath) + 1)]
    _check(cast, scene, view, hidden)
    if is_open(plan):
        check_all_seen(scene, view)
    truth = how_many(scene, cast.counted.id)
    candidates = count_candidates(visible, rng, plan.rules)
    draft = Draft(
        question_type="count",
        scene=scene,
        subject=cast.counted.name,
        slots={"names": str(plural(cast.counted.name))},
        candidates=candidates,
        truth=candidates.index(str(truth)),
        targets=tuple(o.instance for o in scene.objects if o.object_id == cast.counted.id),
        measures={"clear": float(visible), "hidden": float(hidden_ones)},
        drawn_from=candidates,
    )
    return TaskCandidate(write_task(draft, plan, view))


def instances(plan: TaskPlan) -> tuple[int, int]:
    """How many instances are clear, and how many hidden."""
    visible, hidden = (TO_SIX if plan.rules >= SIX_RULES else INSTANCES).of(plan)
    return visible, 0 if is_open(plan) else hidden


def select_count(library: Library, plan: TaskPlan, rng: np.random.Generator) -> _Cast:
    """What is counted, what else is hidden, what covers both, and the crowd.

    Raises:
        Rejected: The library has no such set.
    """
    pool = [spec for spec in hideable(library) if plural(spec.name)]
    reason = ""
    for _ in range(CAST_TRIES):
        counted, *decoys = draw_alike(
            pool,
            library.specs,
            Likeness(LOOSE_TOLERANCE, sides_of(plan.rules)),
            1 + NESTS,
            rng,
            leads=library.leads,
        )
        free = unlike(library.specs, [counted, *decoys])
        room = [footprint_of(library, spec.id) for spec in (counted, *decoys)]
        covers = _draw_covers(library, free, room, rng)
        if len(covers) == NESTS:
            break
        drawn = ", ".join(spec.name for spec in (counted, *decoys))
        reason = f"only {len(covers)} of {NESTS} covers for {drawn}"
    else:
        raise Rejected("cover", reason)
    if library.leading and not any(map(library.leads, (counted, *(c.spec for c in covers)))):
        raise Rejected(LEADING, f"neither {counted.name} nor what covers it is of your own")
    visible, hidden = instances(plan)
    beneath = [] if is_open(plan) else [counted] * hidden + decoys[: NESTS - hidden]
    order = [int(index) for index in rng.permutation(len(beneath))]
    total = int(rng.integers(_FEWEST, _MOST + 1))
    free = unlike(free, [cover.spec for cover in covers])
    crowd = draw_crowd(free, total - len(beneath) - NESTS - visible, rng)
    cast = _Cast(counted, tuple(beneath[index] for index in order), tuple(covers), crowd, visible)
    return _topped(library, cast, rng) if is_topped(plan) and not is_open(plan) else cast


def _topped(library: Library, cast: _Cast, rng: np.random.Generator) -> _Cast:
    """The cast with things on some of its covers, and as many of the crowd less.

    Raises:
        Rejected: The library has nothing that stays on one of them.
    """
    over = some_of(NESTS, rng)
    drawn = draw_toppings(library, cast.specs, [cast.covers[number] for number in over], rng)
    crowd = (*cast.crowd[: len(cast.crowd) - len(drawn)], *drawn)
    return replace(cast, crowd=crowd, topped=tuple(over))


def _draw_covers(
    library: Library,
    free: Sequence[ObjectSpec],
    room: Sequence[Footprint],
    rng: np.random.Generator,
) -> list[Cover]:
    """Covers with different names, each of which may hide any of the things; all there are."""
    covers: list[Cover] = []
    for _ in range(NESTS):
        others = unlike(free, [cover.spec for cover in covers])
        cover = draw_cover(library, others, room, rng)
        if cover:
            covers.append(cover)
    return covers


def _settle(cast: _Cast, stage: Stage, posts: Sequence[Post], rng: np.random.Generator) -> Poses:
    """Nests on two sides of the middle, the crowd around them, open instances last.

    With nothing beneath them, covers are part of the crowd.
    """
    nests: Poses = {}
    for index, post in enumerate(posts):
        lay = right_above(NESTS + index + 1, cast.covers[index])
        nests |= build_nest(stage, index + 1, lay, post, rng)
    falling = [n for n in range(len(nests) + 1, len(cast.specs) + 1) if n not in cast.toppings]
    stage.heap(nests, falling, rng)
    settled = stage.settle(stage.top(cast.toppings, rng))
    check_toppings(cast.toppings, stage, settled)
    return settled


def _draw_posts(covers: Sequence[Cover], wider: float, rng: np.random.Generator) -> list[Post]:
    """Places across the middle from each other, further apart than the covers reach.

    The crowd is kept off discs that are so much wider than the covers.
    """
    angle = float(rng.uniform(0, 2 * math.pi))
    distance = max(_FROM_MIDDLE, sum(cover.reach for cover in covers) / 2)
    turns = angle + 2 * math.pi * np.arange(len(covers)) / len(covers)
    places: Array = distance * np.stack([np.cos(turns), np.sin(turns)], axis=1)
    return [
        Post(float(x), float(y), cover.reach * wider)
        for (x, y), cover in zip(places, covers, strict=True)
    ]


def _check(cast: _Cast, scene: Scene, view: SceneView, hidden: Sequence[int]) -> None:
    """What is beneath is hidden, decoys included; every other instance lies open.

    Raises:
        Rejected: Something is in between.
    """
    instances = [o.instance for o in scene.objects if o.object_id == cast.counted.id]
    seen = view.visibility(scene, view.labels(scene), {*hidden, *instances})
    for number in hidden:
        if not is_hidden(seen[number]):
            share, pixels = seen[number].fraction, seen[number].visible_px
            raise Rejected("hidden", f"{share:.0%}, {pixels} px of one beneath a cover")
    for number in set(instances) - set(hidden):
        if not is_clear(seen[number]):
            raise Rejected("clear", f"only {seen[number].fraction:.0%} of one in the open")


GENERATOR = TaskGenerator(
    generate=generate_count,
    select=select_count,
    needs=f"{needs_alike(LARGEST, LOOSE_TOLERANCE, 1 + NESTS)}; "
    f"over any of them, {NESTS} times, {NEEDS_COVER}",
    turns=(INSTANCES, TO_SIX, OPEN, TOPPED),
)
