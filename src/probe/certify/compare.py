"""Compare: which of two marked things has a colour? The patches that show mislead half the time."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from probe.assets.colour_difference import ciede2000
from probe.assets.library import Library
from probe.certify.leads import Asked, in_the_open, leads_enough, misfit, wanted
from probe.certify.looks import Looks
from probe.certify.marked import (
    INSIDE_PX,
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
from probe.certify.palettes import main_colour, palette_of
from probe.certify.plan import Plan
from probe.certify.result import Candidate, Rejected
from probe.certify.rims import CLEAR, NEAR, Rims, in_shade
from probe.certify.rules import is_clear
from probe.certify.stories import draw_stories
from probe.certify.view import View
from probe.certify.writing import Draft, write_task
from probe.perception.outline import deepest_inside
from probe.render.renderer import Renderer
from probe.scene.scene import Scene
from probe.scene.seeds import generator
from probe.tasks.task import PAIR
from probe.tasks.truth import which_darker, which_like
from probe.types import Array

_PLAIN = 0.6
"""Least share of a thing's main colour: lesser ones aren't what most of it shows when it lies some
other way."""

_TRIES = 2
"""Attempts in a row that want the same patches: what is hard to lay would else become rare where it
misleads, but not where it tells."""

_NEAR_IN_PICTURES = 12.0
"""Likewise as NEAR, once light and reflections are added to textures."""

_ROOM_PX = 1.2 * INSIDE_PX
"""Some of it may be lost to the crowd."""


def generate_compare(
    seed: int, plan: Plan, library: Library, renderer: Renderer, tables: Sequence[str]
) -> Candidate:
    """One attempt.

    Raises:
        Rejected: It failed a check.
    """
    rng = generator(seed, "compare")
    same = generator(seed // _TRIES, "compare", "asked")
    asked, cast = _draw_cast(library, plan, same, rng)
    made = build_set(cast, seed, library, renderer, tables, rng)
    view = made.view
    scene = settle_around(made, _nests(made, asked, library, plan, rng), rng)
    reference = made.frame.number_of[len(cast.specs)] if asked.reference else None
    labels = view.labels(scene)
    _check_reference(view, scene, labels, reference)
    marks = draw_marks(made, labels)
    _check_paint(made, asked, library, plan, scene, labels)
    compared = made.marked if reference is None else (*made.marked, reference)
    looks = Looks(renderer, scene, labels, compared, library)
    measures = _measure(looks, made, asked, plan, reference)
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


def _draw_cast(
    library: Library, plan: Plan, same: np.random.Generator, rng: np.random.Generator
) -> tuple[Asked, MarkedCast]:
    """Two things and what is asked of them, drawn by `same`, and who else plays."""
    rims = _rims(library)
    for story in draw_stories(rims, plan, same):
        asked = story.asked(rims, plan)
        needed = [asked.reference] if asked.reference else []
        if cast := cast_marked(library, asked.marked, needed, rng):
            return asked, cast
    raise Rejected("candidates", f"no two things of which one is clearly {plan.form}")


@lru_cache(maxsize=4)
def _rims(library: Library) -> Rims:
    """Of all that may be marked and is mostly of one colour."""
    pool = markable(library)
    return Rims.of(library, [s for s in pool if palette_of(library, s.id)[0].share >= _PLAIN])


@dataclass(frozen=True, eq=False)
class _Patch:
    """What shows of a thing: main colour, CIELAB, and how many pixels."""

    lab: Array
    area_px: int


def _off_plan(plan: Plan, asked: Asked, colour: Array, patches: Sequence[_Patch]) -> float:
    """How far patches of A and B are from what is to show; infinity if they tell otherwise.

    Args:
        plan: Of the episode.
        asked: With what is to show.
        colour: The colour that is asked for, CIELAB, shape (3,).
        patches: Of A and B.
    """
    lead = asked.lead([float(misfit(plan.form, patch.lab, colour)) for patch in patches])
    right, wrong = patches[asked.right], patches[1 - asked.right]
    if not leads_enough(plan.form, lead) or (lead > 0) != plan.cues[0]:
        return math.inf
    if (right.area_px > wrong.area_px) != plan.cues[1]:
        return math.inf
    off = asked.off([patch.lab for patch in patches])
    return off if off <= NEAR else math.inf


def _nests(
    made: Set, asked: Asked, library: Library, plan: Plan, rng: np.random.Generator
) -> tuple[Nest, Nest]:
    """Nests of both whose patches, by their textures, tell as planned.

    Raises:
        Rejected: None of those that were tried do.
    """
    colour = _planned(asked, library)

    def shown(place: int, nest: Nest) -> _Patch | None:
        mask = nest.labels == made.marked[place]
        if deepest_inside(mask)[1] < _ROOM_PX:
            return None
        shade = made.view.shades(nest.scene, nest.labels, made.marked[place])[0]
        lab = in_shade(np.array(shade.lab))
        return _Patch(lab, int(np.count_nonzero(mask))) if shade.share >= CLEAR else None

    def off(a: _Patch, b: _Patch) -> float:
        return _off_plan(plan, asked, colour, (a, b))

    return draw_nests(made, shown, off, rng, asked.facing)


def _planned(asked: Asked, library: Library) -> Array:
    """The colour that is asked for, as textures let one expect it."""
    model = asked.reference and in_the_open(main_colour(library, asked.reference.id))
    return wanted(asked.word, model)


def _check_paint(
    made: Set, asked: Asked, library: Library, plan: Plan, scene: Scene, labels: Array
) -> None:
    """That patches still tell as planned, by their textures: pictures take many times as long."""
    patches = [
        _Patch(in_shade(made.view.patch(scene, labels, number)), int((labels == number).sum()))
        for number in made.marked
    ]
    if _off_plan(plan, asked, _planned(asked, library), patches) == math.inf:
        raise Rejected("patch", "among the crowd, the patches tell something else than planned")


def _check_reference(view: View, scene: Scene, labels: Array, reference: int | None) -> None:
    if reference is None:
        return
    seen = view.visibility(scene, labels, [reference])[reference]
    if not is_clear(seen):
        raise Rejected("reference", f"only {seen.fraction:.0%} of what it is compared with show")


def _measure(
    looks: Looks, made: Set, asked: Asked, plan: Plan, reference: int | None
) -> dict[str, float]:
    """Checks on pictures that main colours differ in every light, and what the patches tell.

    Raises:
        Rejected: They don't, or the patches tell something else than planned.
    """
    subject = asked.word if reference is None else reference
    misfits = looks.misfits(plan.form, made.marked, subject)
    lead = asked.lead(misfits)
    off = asked.off([looks.patch(number) for number in made.marked])
    if not leads_enough(plan.form, lead) or (lead > 0) != plan.cues[0] or off > _NEAR_IN_PICTURES:
        found = "the patches fit by {:.0f} and {:.0f}".format(*misfits)
        raise Rejected("cues", f"{found}, and are off by {off:.0f}")
    measures = {"patch_lead": lead, "patch_best": min(misfits), "patch_off": off}
    model = reference or made.marked[asked.right]
    for light in looks.lights:
        a, b = (looks.main(number, light) for number in made.marked)
        try:
            if plan.form == "darker":
                found = which_darker(a, b)
            else:
                found = which_like(a, b, looks.main(model, light))
        except ValueError as error:
            raise Rejected("light", f"{light}: {error}") from error
        if found != PAIR[asked.right]:
            raise Rejected("light", f"the other one fits in {light}")
        measures[f"apart_{light}"] = float(ciede2000(a, b))
    return measures
