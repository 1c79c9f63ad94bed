"""Compare: which of two marked things has a colour? The patches that show mislead half the time."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from probe.assets.library import Library
from probe.certify.aim import Aim
from probe.certify.leads import Asked
from probe.certify.looks import Looks
from probe.certify.marked import (
    MarkedCast,
    build_set,
    cast_marked,
    draw_marks,
    markable,
    settle_around,
)
from probe.certify.palettes import palette_of
from probe.certify.plan import Plan
from probe.certify.result import Candidate, Rejected
from probe.certify.rims import Rims
from probe.certify.rules import is_clear
from probe.certify.stories import draw_twins
from probe.certify.view import View
from probe.certify.writing import Draft, write_task
from probe.render.renderer import Renderer
from probe.scene.scene import Scene
from probe.scene.seeds import generator
from probe.tasks.task import PAIR
from probe.types import Array

_PLAIN = 0.6
"""Least share of a thing's main colour: lesser ones aren't what most of it shows when it lies some
other way."""


def generate_compare(
    seed: int, plan: Plan, library: Library, renderer: Renderer, tables: Sequence[str]
) -> Candidate:
    """One attempt.

    Its twin, which shows the same patches and is answered the other way, has to pass all checks as
    well: else what is hard to lay would become rare on one side.

    Raises:
        Rejected: It failed a check, or its twin did.
    """
    rng = generator(seed, "compare")
    one, other = _draw_parts(library, plan, rng)
    candidate = _stage(one, seed, library, renderer, tables, rng)
    try:
        _stage(other, seed, library, renderer, tables, rng)
    except Rejected as failure:
        rejection = failure.rejection
        raise Rejected(f"twin {rejection.check}", rejection.detail) from failure
    return candidate


@dataclass(frozen=True, eq=False)
class _Part:
    """What is planned, what is asked, and who plays."""

    plan: Plan
    asked: Asked
    cast: MarkedCast


def _draw_parts(library: Library, plan: Plan, rng: np.random.Generator) -> tuple[_Part, _Part]:
    """As planned, and its twin."""
    rims = _rims(library)
    for twins in draw_twins(rims, plan.form, rng):
        found = list[_Part]()
        for side in (plan, opposite(plan)):
            asked = twins.asked(rims, side)
            needed = [asked.reference] if asked.reference else []
            if cast := cast_marked(library, asked.marked, needed, rng):
                found.append(_Part(side, asked, cast))
        if len(found) == len(PAIR):
            return found[0], found[1]
    raise Rejected("candidates", f"no two things of which one is clearly {plan.form}")


def opposite(plan: Plan) -> Plan:
    """Of what shows the same under the same letters, but is answered by the other one."""
    tells, more, rest = plan.cues
    letter = PAIR[1 - PAIR.index(plan.letter)]
    return replace(plan, letter=letter, cues=(not tells, not more, rest))


def _stage(
    part: _Part,
    seed: int,
    library: Library,
    renderer: Renderer,
    tables: Sequence[str],
    rng: np.random.Generator,
) -> Candidate:
    """Lay and check one of the two.

    Raises:
        Rejected: It failed a check.
    """
    plan, asked, cast = part.plan, part.asked, part.cast
    aim = Aim.of(plan, asked, library)
    made = build_set(cast, seed, library, renderer, tables, rng)
    view = made.view
    scene = settle_around(made, aim.nests(made, rng), rng)
    reference = made.frame.number_of[len(cast.specs)] if asked.reference else None
    labels = view.labels(scene)
    _check_reference(view, scene, labels, reference)
    marks = draw_marks(made, labels)
    aim.check_paint(made, scene, labels)
    compared = made.marked if reference is None else (*made.marked, reference)
    looks = Looks(renderer, scene, labels, compared, library)
    measures = aim.measure(looks, made.marked, reference)
    draft = Draft(
        kind="compare",
        scene=scene,
        subject=asked.word or (asked.reference.name if asked.reference else ""),
        slots={"colour": asked.word, "name": asked.reference.name if asked.reference else ""},
        candidates=(),
        truth=asked.right,
        targets=made.marked,
        marks=marks,
        measures=measures,
        drawn_from=tuple(spec.id for spec in cast.marked),
    )
    # Looks loaded textures; the certificate's visibilities need none, and both see the same.
    return Candidate(write_task(draft, plan, view))


@lru_cache(maxsize=4)
def _rims(library: Library) -> Rims:
    """Of all that may be marked and is mostly of one colour."""
    pool = markable(library)
    return Rims.of(library, [s for s in pool if palette_of(library, s.id)[0].share >= _PLAIN])


def _check_reference(view: View, scene: Scene, labels: Array, reference: int | None) -> None:
    if reference is None:
        return
    seen = view.visibility(scene, labels, [reference])[reference]
    if not is_clear(seen):
        raise Rejected("reference", f"only {seen.fraction:.0%} of what it is compared with show")
