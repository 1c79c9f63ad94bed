"""Size: which of two marked things is longer, larger or smaller? What shows of them misleads."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy import ndimage

from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.certify.alike import told_apart
from probe.certify.extents import extent_of
from probe.certify.marked import (
    MarkedCast,
    Nest,
    Set,
    build_set,
    cast_marked,
    draw_marks,
    markable,
    settle_around,
)
from probe.certify.pairing import draw_nests
from probe.certify.plan import Plan
from probe.certify.result import Candidate, Rejected
from probe.certify.writing import Draft, write_task
from probe.perception.outline import box_of, window_of
from probe.render.renderer import Renderer
from probe.scene.seeds import generator
from probe.tasks.task import PAIR
from probe.tasks.truth import which_size
from probe.types import Array

_PAIRS = 400

_LARGEST_RATIO = 2.5
"""Most by which the bare areas of the two differ: else a little of both can't look alike."""

_LEADS = ((math.log(1.05), math.log(2.0)), (math.log(1.05), math.log(1.5)), (0.01, 0.3))
"""Least and most by which one of the two shows by more pixels, is longer as far as it shows (both
logarithms of ratios), and has things along more of its outline. The same whichever it is: where
amounts differ, they tell which is larger."""

_BAND_PX = 4


@dataclass(frozen=True)
class _Patch:
    """What shows of a thing.

    Attributes:
        area_px: Its pixels.
        diagonal_px: Of the box around them.
        overlapped: Share of the band around them that belongs to other things, not to the table.
    """

    area_px: int
    diagonal_px: float
    overlapped: float


def generate_size(
    seed: int, plan: Plan, library: Library, renderer: Renderer, tables: Sequence[str]
) -> Candidate:
    """One attempt.

    Raises:
        Rejected: It failed a check.
    """
    rng = generator(seed, "size")
    cast = _draw_cast(library, plan, rng)
    made = build_set(cast, seed, library, renderer, tables, rng)
    view = made.view
    scene = settle_around(made, _nests(made, plan, rng), rng)
    labels = view.labels(scene)
    a, b = (_patch(labels, number) for number in made.marked)
    if not _as_planned(plan, _leads(plan, a, b)):
        raise Rejected("cues", "what shows tells something else than planned")
    seen = view.visibility(scene, labels, made.marked)
    first, second = (seen[number] for number in made.marked)
    a, b = (extent_of(library, spec.id) for spec in cast.marked)
    draft = Draft(
        kind="size",
        scene=scene,
        subject="",
        slots={},
        candidates=(),
        truth=PAIR.index(which_size(plan.form, a, b)),
        targets=made.marked,
        marks=draw_marks(made, labels),
        measures={
            "longest_a": a.longest,
            "longest_b": b.longest,
            "volume_a": a.volume,
            "volume_b": b.volume,
            "visible_a": first.fraction,
            "visible_b": second.fraction,
        },
        drawn_from=tuple(spec.id for spec in cast.marked),
    )
    return Candidate(write_task(draft, plan, view))


def _draw_cast(library: Library, plan: Plan, rng: np.random.Generator) -> MarkedCast:
    """Two things of clearly different size, the right answer under the planned letter."""
    pool = markable(library)
    for _ in range(_PAIRS):
        a, b = (pool[int(index)] for index in rng.choice(len(pool), size=2, replace=False))
        if not told_apart([a, b]) or _bare_ratio(a, b) > _LARGEST_RATIO:
            continue
        try:
            right = which_size(plan.form, extent_of(library, a.id), extent_of(library, b.id))
        except ValueError:
            continue
        cast = cast_marked(library, (a, b) if right == plan.letter else (b, a), (), rng)
        if cast:
            return _covered(cast, plan)
    raise Rejected("candidates", f"no two things of which one is clearly {plan.form}")


def _covered(cast: MarkedCast, plan: Plan) -> MarkedCast:
    """The cast with its longer cover on the thing that it is planned for."""
    longer_on_a = max(cast.covers[0].spec.size) > max(cast.covers[1].spec.size)
    if longer_on_a == (plan.longer_cover == _a_is_larger(plan)):
        return cast
    return replace(cast, covers=(cast.covers[1], cast.covers[0]))


def _a_is_larger(plan: Plan) -> bool:
    return (plan.letter == "A") != (plan.form == "smaller")


def _bare_ratio(a: ObjectSpec, b: ObjectSpec) -> float:
    """Of the areas that two things cover where they lie on their largest side, at least 1."""
    one, other = (math.prod(sorted(spec.size)[1:]) for spec in (a, b))
    return max(one / other, other / one)


def _nests(made: Set, plan: Plan, rng: np.random.Generator) -> tuple[Nest, Nest]:
    """A and B, each beneath its cover so that what shows is as planned.

    Of what is tried, the nearest is taken to a goal that is drawn alike for every plan.
    """
    goal = [sign * rng.uniform(*window) for sign, window in zip(_signs(plan), _LEADS, strict=True)]

    def shown(place: int, nest: Nest) -> _Patch:
        return _patch(nest.labels, made.marked[place])

    def off(a: _Patch, b: _Patch) -> float:
        leads = _leads(plan, a, b)
        return math.dist(leads, goal) if _as_planned(plan, leads) else math.inf

    return draw_nests(made, shown, off, rng)


def _patch(labels: Array, number: int) -> _Patch:
    labels = labels[window_of(labels == number, _BAND_PX)]
    mine = labels == number
    band = labels[ndimage.binary_dilation(mine, iterations=_BAND_PX) & ~mine]
    left, top, right, bottom = box_of(mine)
    diagonal = math.hypot(bottom - top + 1, right - left + 1)
    return _Patch(int(np.count_nonzero(mine)), diagonal, float((band != 0).mean()))


def _leads(plan: Plan, a: _Patch, b: _Patch) -> tuple[float, float, float]:
    """By how much the larger thing shows more, and longer, and with more along its outline."""
    larger, smaller = (a, b) if _a_is_larger(plan) else (b, a)
    return (
        math.log(larger.area_px / smaller.area_px),
        math.log(larger.diagonal_px / smaller.diagonal_px),
        larger.overlapped - smaller.overlapped,
    )


def _signs(plan: Plan) -> list[int]:
    return [1 if cue else -1 for cue in plan.cues]


def _as_planned(plan: Plan, leads: Sequence[float]) -> bool:
    return all(
        least <= sign * lead <= most
        for sign, lead, (least, most) in zip(_signs(plan), leads, _LEADS, strict=True)
    )
