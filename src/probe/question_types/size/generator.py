"""Size: which of two marked things is longer, larger or smaller? What shows of them misleads."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.generation.colour_views import ColourViews
from probe.generation.covers import NEEDS_SHIELD, low_footprint_of
from probe.generation.depth_cues import rims_tell
from probe.generation.in_view import OPEN, is_open
from probe.generation.likeness import told_apart
from probe.generation.marked import (
    MARKABLE,
    CoveredThing,
    MarkedSelection,
    MarkedStage,
    build_set,
    cast_marked,
    draw_marks,
    markable,
    settle_around,
    settle_open,
)
from probe.generation.pairing import draw_nests
from probe.generation.palettes import main_colour
from probe.generation.result import Rejected, TaskCandidate
from probe.generation.sizes import extent_of
from probe.generation.task_generator import TaskGenerator
from probe.generation.task_plan import MORE_CUES, PlannedProperty, TaskPlan
from probe.generation.task_writer import Draft, write_task
from probe.question_types.size.cues import (
    DEPTH,
    MarkedLook,
    PlannedCues,
    has_depth,
    shown_of,
    suits_depth,
)
from probe.render.renderer import Renderer
from probe.scene.seeds import generator
from probe.scene.visibility import Visibility
from probe.tasks.task import AIM_RULES, PAIR
from probe.tasks.truth import Extent, which_size
from probe.types import Array

LIGHTER = PlannedProperty("lighter", (True, False))
"""Whether the larger thing is the lighter one."""

_PAIRS = 400
_CASTS = 6

_LARGEST_RATIO = 2.5
"""Most by which the bare areas of the two differ: else a little of both can't look alike."""


def generate_size(
    seed: int, plan: TaskPlan, library: Library, renderer: Renderer, tables: Sequence[str]
) -> TaskCandidate:
    """One attempt.

    Raises:
        Rejected: It failed a check.
    """
    rng = generator(seed, "size")
    cast = select_size(library, plan, rng)
    a, b = (extent_of(library, spec.id) for spec in cast.marked)
    hidden = not is_open(plan)
    made = build_set(cast, seed, library, renderer, tables, rng, plan.setup, keep_off=hidden)
    view = made.view
    scene = settle_around(made, _nests(made, plan, rng), rng) if hidden else settle_open(made, rng)
    labels, (first, second) = view.labels(scene), made.marked
    cues = PlannedCues.of(plan)
    a_shown, b_shown = (shown_of(made, plan, scene, labels, number) for number in made.marked)
    if hidden and not cues.hold(a_shown, b_shown):
        raise Rejected("cues", "what shows tells something else than planned")
    if a_shown.depth and b_shown.depth and rims_tell(a_shown.depth, b_shown.depth):
        raise Rejected("rims", "one cover lies clear of the table")
    marks = draw_marks(made, labels)
    seen = view.visibility(scene, labels, made.marked)
    looks = ColourViews(renderer, scene, labels, made.marked, library)
    if hidden and not _is_lighter_as_planned(plan, looks.patch(first), looks.patch(second)):
        raise Rejected("cues", "what shows of the other one is lighter")
    draft = Draft(
        question_type="size",
        scene=scene,
        subject="",
        slots={},
        candidates=(),
        truth=PAIR.index(which_size(plan.form, a, b)),
        targets=made.marked,
        marks=marks,
        measures={
            **_measures((a, b), (seen[first], seen[second])),
            **cues.leads(a_shown, b_shown),
        },
        drawn_from=tuple(spec.id for spec in cast.marked),
    )
    # Looks loaded textures; the certificate's visibilities need none, and both see the same.
    return TaskCandidate(write_task(draft, plan, view))


def _measures(
    extents: tuple[Extent, Extent], seen: tuple[Visibility, Visibility]
) -> dict[str, float]:
    (a, b), (seen_a, seen_b) = extents, seen
    return {
        "longest_a": a.longest,
        "longest_b": b.longest,
        "volume_a": a.volume,
        "volume_b": b.volume,
        "visible_a": seen_a.fraction,
        "visible_b": seen_b.fraction,
    }


def select_size(library: Library, plan: TaskPlan, rng: np.random.Generator) -> MarkedSelection:
    """Two things of clearly different size, the right answer under the planned letter.

    Raises:
        Rejected: The library has no two that do, nothing to cover them, or no crowd.
    """
    uncovered = False
    for a, b in draw_pairs(library, rng):
        if not told_apart([a, b]) or _bare_ratio(a, b) > _LARGEST_RATIO:
            continue
        try:
            right = which_size(plan.form, extent_of(library, a.id), extent_of(library, b.id))
        except ValueError:
            continue
        pair = (a, b) if right == plan.letter else (b, a)
        first, second = (main_colour(library, spec.id) for spec in pair)
        if not _is_lighter_as_planned(plan, first, second):
            continue
        heights = [low_footprint_of(library, spec.id).height for spec in pair]
        if not suits_depth(heights, plan, place=1):
            continue
        if cast := _cast(library, pair, heights, plan, rng):
            return cast
        uncovered = True
    if uncovered:
        raise Rejected("cover", "no two things cover any pair that was drawn")
    raise Rejected("candidates", f"no two things of which one is clearly {plan.form}")


def _cast(
    library: Library,
    pair: tuple[ObjectSpec, ObjectSpec],
    heights: Sequence[float],
    plan: TaskPlan,
    rng: np.random.Generator,
) -> MarkedSelection | None:
    """A pair, of these heights, with covers that go with the plan; None if none drawn do."""
    for _ in range(_CASTS if has_depth(plan) else 1):
        if not (drawn := cast_marked(library, pair, (), rng, closed=plan.rules >= AIM_RULES)):
            return None
        cast = _covered(drawn, plan)
        tops = [h + cover.extent[2] for h, cover in zip(heights, cast.covers, strict=True)]
        if suits_depth(tops, plan, place=0):
            return cast
    return None


def draw_pairs(
    library: Library, rng: np.random.Generator
) -> Iterator[tuple[ObjectSpec, ObjectSpec]]:
    """Pairs at random; where things lead, of one of those and any other.

    In half of the calls those come first of which both lead: a small library has few, and few of
    those lie as planned.

    Raises:
        Rejected: Too few things have a size to be marked.
    """
    pool = markable(library)
    leading = [spec for spec in pool if library.leads(spec)]
    if len(pool) < len(PAIR) or (library.leading and not leading):
        mine = " of your own" if library.leading else ""
        raise Rejected("candidates", f"{MARKABLE}: too few things{mine}")
    alone = len(leading) >= len(PAIR) and rng.random() < 1 / 2
    for number in range(_PAIRS):
        if not library.leading:
            first, second = rng.choice(len(pool), size=2, replace=False)
            yield pool[int(first)], pool[int(second)]
            continue
        one = leading[int(rng.integers(len(leading)))]
        among = leading if alone and 2 * number < _PAIRS else pool
        others = [spec for spec in among if spec is not one]
        yield one, others[int(rng.integers(len(others)))]


def _covered(cast: MarkedSelection, plan: TaskPlan) -> MarkedSelection:
    """The cast with its longer cover on the thing that it is planned for."""
    longer_on_a = max(cast.covers[0].spec.size) > max(cast.covers[1].spec.size)
    if longer_on_a == (MORE_CUES.of(plan)[1] == PlannedCues.of(plan).a_is_larger):
        return cast
    return replace(cast, covers=(cast.covers[1], cast.covers[0]))


def _is_lighter_as_planned(plan: TaskPlan, a: Array, b: Array) -> bool:
    """By colours in CIELAB."""
    return bool(a[0] > b[0]) == (LIGHTER.of(plan) == PlannedCues.of(plan).a_is_larger)


def _bare_ratio(a: ObjectSpec, b: ObjectSpec) -> float:
    """Of the areas that two things cover where they lie on their largest side, at least 1."""
    one, other = (math.prod(sorted(spec.size)[1:]) for spec in (a, b))
    return max(one / other, other / one)


def _nests(
    made: MarkedStage, plan: TaskPlan, rng: np.random.Generator
) -> tuple[CoveredThing, CoveredThing]:
    """A and B, each beneath its cover so that what shows is as planned.

    Of what is tried, the nearest is taken to a goal that is drawn alike for every plan.
    """
    cues = PlannedCues.of(plan)
    goal = cues.goal(rng)

    def shown(place: int, nest: CoveredThing) -> MarkedLook:
        return shown_of(made, plan, nest.scene, nest.labels, made.marked[place])

    return draw_nests(made, shown, lambda a, b: cues.off(a, b, goal), rng)


GENERATOR = TaskGenerator(
    generate=generate_size,
    select=select_size,
    needs="two things of which one is clearly larger "
    f"({MARKABLE}); over either, two {NEEDS_SHIELD}",
    turns=(MORE_CUES, LIGHTER, DEPTH, OPEN),
)
