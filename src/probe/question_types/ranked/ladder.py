"""Draws what lies beneath the covers in Ranked, so that options' sizes tell nothing.

Five candidates are drawn first, of several lengths, and then two more things, never among the
options, that frame them: beside these two, each of the five would have the rank that is asked for.
So each can be the answer, and which one is, is drawn afterwards, evenly. Where another candidate
does as well as one of the two, it takes its place, so that several options lie on the table.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from itertools import combinations, pairwise

import numpy as np

from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.generation.alike import is_lying, unlike
from probe.generation.covers import footprint_of
from probe.generation.likeness import longest, told_apart
from probe.generation.object_selection import LARGEST, SMALLEST, hideable
from probe.generation.result import Rejected
from probe.generation.side_by_side import Hidden
from probe.question_types.ranked.rules import RANKS
from probe.question_types.ranked.truth import has_rank
from probe.scene.turns import in_turn
from probe.tasks.options import CANDIDATES
from probe.tasks.truth import LONGER
from probe.tasks.type_rules import Form

NEEDS_LADDER = (
    f"{CANDIDATES} things and two that are clearly (by {LONGER - 1:.0%}) longer or shorter, all "
    f"{100 * SMALLEST:g} to {100 * LARGEST:g} cm long, lying, unlike in name and colour"
)
"""What lies beneath the covers, for people."""

_SPAN = 1.7
"""The longest candidate by the shortest, at most."""

_RIVALLED = 3
"""Candidates, at least, beside which another one may lie on the table."""

_FEW = 0.05
"""Share of all things that at least is short enough, or long enough, to frame the candidates."""

_TRIES, _LOOKED_AT = 100, 40


def draw_ladder(library: Library, form: Form, rng: np.random.Generator) -> Hidden:
    """Draw five candidates and the two things that frame them.

    Raises:
        Rejected: The library has no such seven, or they weren't found.
    """
    pool = [spec for spec in hideable(library) if is_lying(spec)]
    if not pool:
        raise Rejected("candidates", "nothing here is of the right size")
    for _ in range(_TRIES):
        order = in_turn(pool, library.leads, rng)
        candidates = _spanned(_with_room(form, order))
        frame = _framing(form, candidates, order) if len(candidates) == CANDIDATES else None
        if frame and _rivalled(form, (*candidates, *frame)) >= _RIVALLED:
            room = tuple(footprint_of(library, spec.id) for spec in (*candidates, *frame))
            return Hidden(candidates, frame, room)
    raise Rejected("candidates", f"no {CANDIDATES} of {len(pool)} things with two that frame them")


def looks_ordered(specs: Iterable[ObjectSpec]) -> bool:
    """Whether no box around one of some things is longer than the next longer thing lying straight.

    However the shorter one is turned: the longest box around it is as long as its diagonal.
    """
    order = sorted(specs, key=longest, reverse=True)
    return all(longest(one) >= math.hypot(*other.size[:2]) for one, other in pairwise(order))


def companions(form: Form, specs: Sequence[ObjectSpec], index: int) -> list[tuple[int, int]]:
    """Pairs of the others beside which a candidate has the rank that is asked for, and looks it.

    Those with another candidate, if there are any.

    Args:
        form: What is asked for.
        specs: The candidates, and then those that frame them.
        index: The candidate's.
    """
    others = [number for number in range(len(specs)) if number != index]
    fitting = [
        (one, other)
        for one, other in combinations(others, 2)
        if _suits(form, specs[index], (specs[one], specs[other]))
    ]
    return [pair for pair in fitting if pair[0] < CANDIDATES] or fitting


def _with_room(form: Form, order: Sequence[ObjectSpec]) -> Sequence[ObjectSpec]:
    """Those that leave room for things clearly longer and shorter, as the rank has it."""
    sizes, longer = [longest(spec) for spec in order], RANKS.index(form)
    short, long = np.quantile(sizes, (_FEW, 1 - _FEW))
    low = short * LONGER ** (len(RANKS) - 1 - longer)
    high = long / LONGER**longer
    return [spec for spec, size in zip(order, sizes, strict=True) if low <= size <= high]


def _spanned(order: Sequence[ObjectSpec]) -> tuple[ObjectSpec, ...]:
    """The first five whose names and colours differ, and whose lengths don't differ too much."""
    drawn: list[ObjectSpec] = []
    for spec in order:
        sizes = [longest(each) for each in (*drawn, spec)]
        if max(sizes) <= _SPAN * min(sizes) and told_apart([*drawn, spec]):
            drawn.append(spec)
        if len(drawn) == CANDIDATES:
            break
    return tuple(drawn)


def _framing(
    form: Form, candidates: Sequence[ObjectSpec], order: Sequence[ObjectSpec]
) -> tuple[ObjectSpec, ...] | None:
    """Two things beside which each of the candidates has the rank that is asked for."""
    low, high = min(map(longest, candidates)), max(map(longest, candidates))
    off = [it for it in order if not low / LONGER < longest(it) < LONGER * high]
    for one, other in combinations(unlike(off, candidates)[:_LOOKED_AT], 2):
        if told_apart([one, other]) and all(_suits(form, it, (one, other)) for it in candidates):
            return one, other
    return None


def _suits(form: Form, spec: ObjectSpec, others: Sequence[ObjectSpec]) -> bool:
    ranked = has_rank(form, longest(spec), [longest(other) for other in others])
    return ranked and looks_ordered((spec, *others))


def _rivalled(form: Form, specs: Sequence[ObjectSpec]) -> int:
    """Candidates beside which another candidate may lie."""
    pairs = (companions(form, specs, index) for index in range(CANDIDATES))
    return sum(found[0][0] < CANDIDATES for found in pairs)
