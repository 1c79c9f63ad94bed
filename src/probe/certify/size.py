"""Size: which of two marked things is longer, larger or smaller? What shows of them misleads."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

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
    partly_covered,
    settle_around,
)
from probe.certify.plan import Plan
from probe.certify.result import Candidate, Rejected
from probe.certify.rules import LITTLE
from probe.certify.writing import Draft, write_task
from probe.render.renderer import Renderer
from probe.scene.seeds import generator
from probe.scene.visibility import Visibility
from probe.tasks.task import PAIR
from probe.tasks.truth import which_size

_PAIRS = 400
_SHARES = 200
_NESTS = 4
_CLEARLY = 1.25
"""Ratio from which on one patch counts as larger than the other."""


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
    nests = _nests(made, library, plan, rng)
    scene = settle_around(made, nests, rng)
    seen = view.visibility(scene, view.labels(scene), made.marked)
    first, second = (seen[number] for number in made.marked)
    large = _larger_first(library, cast.marked)
    _check_cues(plan, (first, second) if large else (second, first))
    a, b = (extent_of(library, spec.id) for spec in cast.marked)
    draft = Draft(
        kind="size",
        scene=scene,
        subject="",
        slots={},
        candidates=(),
        truth=PAIR.index(which_size(plan.form, a, b)),
        targets=made.marked,
        marks=draw_marks(made, scene),
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
        if not told_apart([a, b]):
            continue
        try:
            right = which_size(plan.form, extent_of(library, a.id), extent_of(library, b.id))
        except ValueError:
            continue
        cast = cast_marked(library, (a, b) if right == plan.letter else (b, a), (), rng)
        if cast:
            return cast
    raise Rejected("candidates", f"no two things of which one is clearly {plan.form}")


def _larger_first(library: Library, marked: Sequence[ObjectSpec]) -> bool:
    """Whether A is the longer one."""
    a, b = (extent_of(library, spec.id) for spec in marked)
    return a.longest > b.longest


def _nests(made: Set, library: Library, plan: Plan, rng: np.random.Generator) -> tuple[Nest, Nest]:
    """Both things, each showing as much as makes the cues right or wrong, as planned."""
    alone = _alone(made, rng)
    large = _larger_first(library, made.cast.marked)
    for _ in range(_NESTS):
        shares = _shares(alone, plan, large, rng)
        first = partly_covered(made, 0, shares[0], rng)
        second = first and partly_covered(made, 1, shares[1], rng)
        if first and second:
            pair = (first.seen, second.seen) if large else (second.seen, first.seen)
            if _tells(*pair) == plan.cues:
                return first, second
    raise Rejected("nest", "the covers leave too much or too little in view")


def _alone(made: Set, rng: np.random.Generator) -> tuple[int, int]:
    """Pixels of both where they lie without covers."""
    found: list[int] = []
    for place in (0, 1):
        tries = (partly_covered(made, place, sum(LITTLE) / 2, rng) for _ in range(_NESTS))
        nest = next((nest for nest in tries if nest), None)
        if nest is None:
            raise Rejected("nest", f"{made.cast.covers[place].spec.name} can't cover a part")
        found.append(nest.seen.alone_px)
    return found[0], found[1]


def _shares(
    alone: tuple[int, int], plan: Plan, large_first: bool, rng: np.random.Generator
) -> tuple[float, float]:
    """Shares of A and B that are to show, drawn evenly from those that suit the plan.

    Raises:
        Rejected: There are none.
    """
    for _ in range(_SHARES):
        shares: tuple[float, float] = tuple(rng.uniform(*LITTLE, size=2).tolist())
        seen = [Visibility(round(s * whole), whole) for s, whole in zip(shares, alone, strict=True)]
        if _tells(*(seen if large_first else seen[::-1])) == plan.cues:
            return shares
    raise Rejected("cues", f"no parts of {alone[0]} and {alone[1]} px would mislead as planned")


def _tells(larger: Visibility, smaller: Visibility) -> tuple[bool, bool] | None:
    """Whether the larger thing shows by clearly more pixels, and by a clearly larger share.

    None where either is unclear.
    """
    pixels = larger.visible_px / max(1, smaller.visible_px)
    share = larger.fraction / max(1e-6, smaller.fraction)
    if any(1 / _CLEARLY < ratio < _CLEARLY for ratio in (pixels, share)):
        return None
    return pixels > 1, share > 1


def _check_cues(plan: Plan, seen: tuple[Visibility, Visibility]) -> None:
    if _tells(*seen) != plan.cues:
        raise Rejected("cues", "what shows tells something else than planned")
