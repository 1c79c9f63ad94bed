"""The same two patches twice: once they mislead, once they tell. Drawn for Compare.

A thing that shows another colour than its own is rare, so whatever is peculiar to such patches
would give the answer away. Each pair of patches that misleads is therefore shared with another
pair of things that show the same, of which the one whose patch fits better is the right one.
Without such a pair it isn't used at all.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from probe.certify.alike import told_apart
from probe.certify.leads import PLAUSIBLE, Asked, in_the_open, least_lead, misfit, wanted
from probe.certify.palettes import dimmed
from probe.certify.plan import Plan
from probe.certify.rims import Rims
from probe.tasks.task import PAIR, Form
from probe.tasks.truth import which_darker, which_like
from probe.types import Array

_DRAWS = 4000

_DIM = 0.75
"""Cube root of the least light in which an answer must hold; pictures then look at real lights."""


@dataclass(frozen=True, eq=False)
class Story:
    """Two things of which one is right, and what is to show of them.

    Attributes:
        right, wrong: Places among the rims' things.
        third: Likewise, of the thing whose colour is asked for; None if none is.
        patches: Of the right one and of the wrong one, CIELAB, shape (3,) each.
    """

    right: int
    wrong: int
    third: int | None
    patches: tuple[Array, Array]

    def asked(self, rims: Rims, plan: Plan) -> Asked:
        """The question that a plan asks about it."""
        order = (self.right, self.wrong), self.patches
        if plan.letter != PAIR[0]:
            order = (self.wrong, self.right), self.patches[::-1]
        (a, b), (patch_a, patch_b) = order
        return Asked(
            marked=(rims.specs[a], rims.specs[b]),
            right=PAIR.index(plan.letter),
            word=_word(rims, self.right) if plan.form == "colour" else "",
            reference=None if self.third is None else rims.specs[self.third],
            patches=(patch_a, patch_b),
            facing=(rims.facing(a, patch_a), rims.facing(b, patch_b)),
        )


@dataclass(frozen=True, eq=False)
class Twins:
    """Two stories of the same patches, of which one tells and one misleads."""

    telling: Story
    misleading: Story

    def asked(self, rims: Rims, plan: Plan) -> Asked:
        """The question that a plan asks about one of them."""
        return (self.telling if plan.cues[0] else self.misleading).asked(rims, plan)


def draw_twins(rims: Rims, form: Form, rng: np.random.Generator) -> Iterator[Twins]:
    """Stories of a form, in twos."""
    odd = rims.odd()
    for _ in range(_DRAWS):
        misleading = _misleading(rims, odd, form, rng)
        telling = misleading and _telling(rims, form, misleading, rng)
        if misleading and telling:
            yield Twins(telling, misleading)


def _misleading(rims: Rims, odd: Array, form: Form, rng: np.random.Generator) -> Story | None:
    """Two things of which the wrong one's patch fits better; one shows a colour not its own."""
    right_is_odd = bool(rng.integers(2))
    right = int(rng.choice(odd if right_is_odd else len(rims.specs)))
    shown = rims.colours[rng.choice(np.flatnonzero(rims.owner == right))]
    third = _third(rims, right, rng) if form == "like" else None
    if form == "like" and third is None:
        return None
    colour = _wanted(rims, form, right, third)
    misfits = misfit(form, rims.colours, colour)
    fitting = float(misfit(form, shown, colour)) - misfits >= least_lead(form)
    if form != "darker":
        fitting &= misfits <= PLAUSIBLE
    others = np.unique(rims.owner[fitting])
    for wrong in rng.permutation(others if right_is_odd else np.intersect1d(others, odd)):
        if _may_ask(rims, form, right, int(wrong), third):
            other = rims.colours[rng.choice(np.flatnonzero(fitting & (rims.owner == wrong)))]
            return Story(right, int(wrong), third, (shown, other))
    return None


def _telling(rims: Rims, form: Form, twin: Story, rng: np.random.Generator) -> Story | None:
    """Two things that show the same as those of a misleading story; the one that fits is right."""
    shown, other = twin.patches[::-1]
    wrongs = rng.permutation(rims.showing(other))
    for right in rng.permutation(rims.showing(shown)):
        if form == "colour" and _word(rims, right) != _word(rims, twin.right):
            continue
        for wrong in wrongs:
            if _may_ask(rims, form, int(right), int(wrong), twin.third):
                return Story(int(right), int(wrong), twin.third, (shown, other))
    return None


def _third(rims: Rims, right: int, rng: np.random.Generator) -> int | None:
    """Another thing whose colour has the same name."""
    words = [_word(rims, place) for place in range(len(rims.specs))]
    same = [place for place, word in enumerate(words) if word == words[right] and place != right]
    return int(rng.choice(same)) if same else None


def _wanted(rims: Rims, form: Form, right: int, third: int | None) -> Array:
    model = None if third is None else in_the_open(rims.main[third])
    return wanted(_word(rims, right) if form == "colour" else "", model)


def _may_ask(rims: Rims, form: Form, right: int, wrong: int, third: int | None) -> bool:
    """Whether one thing is clearly what is asked for, by annotated colours and by textures."""
    places = [right, wrong] if third is None else [right, wrong, third]
    if not told_apart([rims.specs[place] for place in places]):
        return False
    if form != "darker":
        word = _word(rims, right)
        if word.split()[-1] in {colour.split()[-1] for colour in rims.specs[wrong].colours}:
            return False
        if third is not None and _word(rims, third) != word:
            return False
    model = right if third is None else third
    lit = (dimmed(rims.main[[right, wrong, model]], root) for root in (1.0, _DIM))
    return all(_is_right(form, *colours) for colours in lit)


def _is_right(form: Form, right: Array, wrong: Array, model: Array) -> bool:
    """By main colours, CIELAB, shape (3,) each."""
    try:
        first = which_darker(right, wrong) if form == "darker" else which_like(right, wrong, model)
    except ValueError:
        return False
    return first == PAIR[0]


def _word(rims: Rims, place: int) -> str:
    """Name of a thing's main colour."""
    return rims.specs[place].colours[0]
