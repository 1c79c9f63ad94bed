"""What Compare asks about: two things of which each could be the right one, by its paint alone."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from probe.assets.colour.difference import ciede2000
from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.generation.colour_cues import least_lead, misfit, wanted
from probe.generation.likeness import told_apart
from probe.generation.paint_twins import PaintTwins
from probe.generation.palettes import dimmed, main_colour
from probe.generation.task_plan import CROSSED, TaskPlan
from probe.perception.colour_words import colours_in
from probe.tasks.task import PAIR
from probe.tasks.truth import which_fits
from probe.tasks.type_rules import Form
from probe.types import Array

_DRAWS = 4000

_SAME = 5.0
"""CIEDE2000 up to which sides look the same."""

_DIM = 0.75
"""Cube root of the least light in which an answer must hold; pictures then look at real lights."""


@dataclass(frozen=True, eq=False)
class TwinSide:
    """One of the two.

    Attributes:
        right: Painted so that it is the right one.
        wrong: The same thing, painted so that it isn't.
        patch: What shows of it in either case, by texture, CIELAB, shape (3,).
        facing: Angles of its sides that show it, radians, shape (n,).
    """

    right: ObjectSpec
    wrong: ObjectSpec
    patch: Array
    facing: Array


@dataclass(frozen=True, eq=False)
class TwinPair:
    """Two worlds that look the same: in each the one thing is right and the other isn't.

    Attributes:
        fitting: The thing whose patch fits better what is asked.
        other: The other one.
        third: The thing in plain view whose colour is asked for, or None.
        word: The colour's name; empty where none is named.
    """

    fitting: TwinSide
    other: TwinSide
    third: ObjectSpec | None
    word: str

    def asked(self, plan: TaskPlan) -> ColourQuestion:
        """The question that a plan asks: who is A, and which of the two worlds it is."""
        tells, a_is_right = CROSSED.of(plan)[1], plan.letter == PAIR[0]
        a, b = (self.fitting, self.other) if tells == a_is_right else (self.other, self.fitting)
        worlds = (a.right, b.wrong), (a.wrong, b.right)
        marked, twins = worlds if a_is_right else worlds[::-1]
        right = PAIR.index(plan.letter)
        return ColourQuestion(marked, twins, right, self.word, self.third, (a.facing, b.facing))


@dataclass(frozen=True, eq=False)
class ColourQuestion:
    """What is asked about, and what their colour is compared with.

    Attributes:
        marked: A and B.
        twins: What lies there in the other world, which is answered the other way.
        right: Index of the right one.
        word: The colour's name; empty where none is named.
        reference: The thing in plain view whose colour is asked for, or None.
        facing: Angles of the sides of A and of B that may show, radians.
    """

    marked: tuple[ObjectSpec, ObjectSpec]
    twins: tuple[ObjectSpec, ObjectSpec]
    right: int
    word: str
    reference: ObjectSpec | None
    facing: tuple[Array, Array]


def draw_duels(
    library: Library, twins: tuple[PaintTwins, ...], form: Form, rng: np.random.Generator
) -> Iterator[TwinPair]:
    """Duels of a form; what kinds of things there are comes up evenly, however many of each."""
    kinds = sorted({each.pair[0].category for each in twins})
    by_kind = {k: [each for each in twins if each.pair[0].category == k] for k in kinds}
    for _ in range(_DRAWS if len(kinds) > 1 else 0):
        one, other = (kinds[int(n)] for n in rng.choice(len(kinds), size=2, replace=False))
        sides = [_draw_side(by_kind[kind], rng) for kind in (one, other)]
        third = _draw_third(library, sides[0].right, rng) if form == "like" else None
        if form != "like" or third is not None:
            duel = _duel(library, form, sides[0], sides[1], third)
            if duel is not None:
                yield duel


def _draw_side(twins: list[PaintTwins], rng: np.random.Generator) -> TwinSide:
    drawn = twins[int(rng.integers(len(twins)))]
    right, wrong = (drawn.pair[int(n)] for n in rng.permutation(2))
    patch = drawn.patches[int(rng.integers(len(drawn.patches)))]
    facing = drawn.angles[ciede2000(drawn.patches, patch) <= _SAME]
    return TwinSide(right, wrong, patch, facing)


def _draw_third(library: Library, right: ObjectSpec, rng: np.random.Generator) -> ObjectSpec | None:
    """Another thing whose main colour has the same name."""
    same = [s for s in library.specs if s.colours[0] == right.colours[0] and s is not right]
    return same[int(rng.integers(len(same)))] if same else None


def _duel(
    library: Library, form: Form, one: TwinSide, other: TwinSide, third: ObjectSpec | None
) -> TwinPair | None:
    """The two as a duel; None if either world wouldn't be clear, or what shows hardly differs."""
    word = one.right.colours[0]
    if form == "colour" and not colours_in(word):
        return None  # people's own words for what they import
    worlds = (one.right, other.wrong), (other.right, one.wrong)
    for right, wrong in worlds:
        if form != "darker" and (right.colours[0] != word or _has(wrong, word)):
            return None
        if not told_apart([right, wrong, *([third] if third else [])]):
            return None
        if not _is_clear(library, form, right, wrong, third):
            return None
    asked = word if form == "colour" else ""
    colour = wanted(asked, None if third is None else main_colour(library, third.id))
    lead = float(misfit(form, other.patch, colour) - misfit(form, one.patch, colour))
    if abs(lead) < least_lead(form):
        return None
    fitting, less = (one, other) if lead > 0 else (other, one)
    return TwinPair(fitting, less, third, asked)


def _has(spec: ObjectSpec, word: str) -> bool:
    """Whether some part of a thing has a colour's name, light and dark being the same."""
    return word.split()[-1] in {colour.split()[-1] for colour in spec.colours}


def _is_clear(
    library: Library, form: Form, right: ObjectSpec, wrong: ObjectSpec, third: ObjectSpec | None
) -> bool:
    """Whether one thing is what is asked for, by main colours of textures, in any light."""
    model = right if third is None else third
    colours = np.array([main_colour(library, spec.id) for spec in (right, wrong, model)])
    lit = (dimmed(colours, root) for root in (1.0, _DIM))
    return all(_is_right(form, *each) for each in lit)


def _is_right(form: Form, right: Array, wrong: Array, model: Array) -> bool:
    """By main colours, CIELAB, shape (3,) each."""
    try:
        return which_fits(form, right, wrong, model) == PAIR[0]
    except ValueError:
        return False
