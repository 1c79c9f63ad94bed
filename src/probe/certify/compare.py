"""Compare: which of two marked things has a colour? The patches that show mislead half the time."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from probe.assets.colour_difference import ciede2000
from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.certify.alike import told_apart
from probe.certify.leads import Asked, could_show, in_the_open, off_plan, shaded
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
from probe.certify.rims import CLEAR
from probe.certify.rules import is_clear
from probe.certify.view import View
from probe.certify.writing import Draft, write_task
from probe.perception.outline import deepest_inside
from probe.render.renderer import Renderer
from probe.scene.scene import Scene
from probe.scene.seeds import generator
from probe.tasks.task import PAIR, Form
from probe.tasks.truth import which_darker, which_like
from probe.types import Array

_PAIRS = 2000
_PLAIN = 0.6
"""Least share of a thing's main colour: lesser ones aren't what most of it shows when it lies some
other way."""

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
    asked, cast = _draw_cast(library, plan, rng)
    made = build_set(cast, seed, library, renderer, tables, rng)
    view = made.view
    scene = settle_around(made, _nests(made, asked, library, plan, rng), rng)
    reference = made.frame.number_of[len(cast.specs)] if asked.reference else None
    labels = view.labels(scene)
    _check_reference(view, scene, labels, reference)
    marks = draw_marks(made, labels)
    compared = made.marked if reference is None else (*made.marked, reference)
    _check_paint(made, asked, plan, scene, labels, compared)
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


def _draw_cast(library: Library, plan: Plan, rng: np.random.Generator) -> tuple[Asked, MarkedCast]:
    """Two things and what is asked of them, such that patches could tell as planned."""
    pool = markable(library)
    for _ in range(_PAIRS):
        a, b, third = (pool[int(index)] for index in rng.choice(len(pool), size=3, replace=False))
        needed = [third] if plan.form == "like" else []
        asked = _asked(plan, (a, b), third) if told_apart([a, b, *needed]) else None
        if asked is None or _truth(library, plan.form, asked) != plan.letter:
            continue
        if any(palette_of(library, spec.id)[0].share < _PLAIN for spec in (a, b, *needed)):
            continue
        if could_show(library, plan, asked) and (cast := cast_marked(library, (a, b), needed, rng)):
            return asked, cast
    raise Rejected("candidates", f"no two things of which one is clearly {plan.form}")


def _asked(plan: Plan, marked: tuple[ObjectSpec, ObjectSpec], third: ObjectSpec) -> Asked | None:
    """What may be asked of two things by their annotated colours; None if that would be unclear."""
    right = PAIR.index(plan.letter)
    if plan.form == "darker":
        return Asked(marked, right, "", None)
    word = (third if plan.form == "like" else marked[right]).colours[0]
    if marked[right].colours[0] != word or _has_colour(marked[1 - right], word):
        return None
    return (
        Asked(marked, right, "", third) if plan.form == "like" else Asked(marked, right, word, None)
    )


def _has_colour(spec: ObjectSpec, word: str) -> bool:
    """Whether a colour's name is among a thing's, whatever its shade."""
    return word.split()[-1] in {colour.split()[-1] for colour in spec.colours}


def _truth(library: Library, form: Form, asked: Asked) -> str:
    """The letter by the textures; empty if it isn't clear."""
    a, b = (main_colour(library, spec.id) for spec in asked.marked)
    wanted = main_colour(library, asked.model.id)
    try:
        return which_darker(a, b) if form == "darker" else which_like(a, b, wanted)
    except ValueError:
        return ""


def _nests(
    made: Set, asked: Asked, library: Library, plan: Plan, rng: np.random.Generator
) -> tuple[Nest, Nest]:
    """Nests of both whose patches, by their textures, tell as planned.

    Raises:
        Rejected: None of those that were tried do.
    """
    wanted = in_the_open(main_colour(library, asked.model.id))

    def shown(place: int, nest: Nest) -> float | None:
        number = made.marked[place]
        if deepest_inside(nest.labels == number)[1] < _ROOM_PX:
            return None
        shade = made.view.shades(nest.scene, nest.labels, number)[0]
        return shaded(plan.form, np.array(shade.lab), wanted) if shade.share >= CLEAR else None

    return draw_nests(made, shown, lambda a, b: off_plan(plan, asked, (a, b)), rng)


def _check_paint(
    made: Set, asked: Asked, plan: Plan, scene: Scene, labels: Array, compared: Sequence[int]
) -> None:
    """That patches still tell as planned, by their textures: pictures take many times as long."""
    bare, patch = scene.only(*compared), made.view.patch
    model = compared[-1] if asked.reference else made.marked[asked.right]
    wanted = in_the_open(patch(bare, made.view.labels(bare), model))
    misfits = [shaded(plan.form, patch(scene, labels, number), wanted) for number in made.marked]
    if off_plan(plan, asked, misfits) == math.inf:
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
    model = reference or made.marked[asked.right]
    misfits = looks.misfits(plan.form, made.marked, model)
    if off_plan(plan, asked, misfits) == math.inf:
        raise Rejected("cues", "the patches fit by {:.0f} and {:.0f}".format(*misfits))
    measures = {"patch_lead": asked.lead(misfits), "patch_best": min(misfits)}
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
