"""What is to show of the two things that Compare asks about, and whether it does."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from probe.assets.colour_difference import ciede2000
from probe.assets.library import Library
from probe.certify.leads import Asked, in_the_open, leads_enough, misfit, wanted
from probe.certify.looks import Looks
from probe.certify.marked import INSIDE_PX, Nest, Set
from probe.certify.pairing import draw_nests
from probe.certify.palettes import main_colour
from probe.certify.plan import Plan
from probe.certify.result import Rejected
from probe.certify.rims import CLEAR, NEAR, in_shade
from probe.perception.outline import deepest_inside
from probe.scene.scene import Scene
from probe.tasks.task import PAIR
from probe.tasks.truth import which_darker, which_like
from probe.types import Array

_NEAR_IN_PICTURES = 12.0
"""Likewise as NEAR, once light and reflections are added to textures."""

_ROOM_PX = 1.2 * INSIDE_PX
"""Some of it may be lost to the crowd."""


@dataclass(frozen=True, eq=False)
class _Patch:
    """What shows of a thing: main colour, CIELAB, and how many pixels."""

    lab: Array
    area_px: int


@dataclass(frozen=True, eq=False)
class Aim:
    """What is planned and asked.

    Attributes:
        plan: Whether patches tell, and of which thing more shows.
        asked: With the patches that are to show.
        colour: The one that is asked for, as textures let one expect it, CIELAB, shape (3,).
    """

    plan: Plan
    asked: Asked
    colour: Array

    @staticmethod
    def of(plan: Plan, asked: Asked, library: Library) -> Aim:
        """Of a plan and its question."""
        model = asked.reference and in_the_open(main_colour(library, asked.reference.id))
        return Aim(plan, asked, wanted(asked.word, model))

    def nests(self, made: Set, rng: np.random.Generator) -> tuple[Nest, Nest]:
        """Nests of both whose patches, by their textures, tell as planned.

        Raises:
            Rejected: None of those that were tried do.
        """

        def shown(place: int, nest: Nest) -> _Patch | None:
            mask = nest.labels == made.marked[place]
            if deepest_inside(mask)[1] < _ROOM_PX:
                return None
            shade = made.view.shades(nest.scene, nest.labels, made.marked[place])[0]
            lab = in_shade(np.array(shade.lab))
            return _Patch(lab, int(np.count_nonzero(mask))) if shade.share >= CLEAR else None

        return draw_nests(made, shown, self._off, rng, self.asked.facing)

    def check_paint(self, made: Set, scene: Scene, labels: Array) -> None:
        """That patches still tell as planned, by their textures: pictures take far longer.

        Raises:
            Rejected: They don't.
        """
        a, b = (
            _Patch(in_shade(made.view.patch(scene, labels, number)), int((labels == number).sum()))
            for number in made.marked
        )
        if self._off(a, b) == math.inf:
            raise Rejected("patch", "among the crowd, the patches tell something else than planned")

    def measure(
        self, looks: Looks, marked: tuple[int, int], reference: int | None
    ) -> dict[str, float]:
        """Checks on pictures that main colours differ in every light, and what the patches tell.

        Args:
            looks: The pictures.
            marked: Numbers of A and B.
            reference: Number of the thing whose colour is asked for, or None.

        Raises:
            Rejected: They don't, or the patches tell something else than planned.
        """
        subject = self.asked.word if reference is None else reference
        misfits = looks.misfits(self.plan.form, marked, subject)
        lead = self.asked.lead(misfits)
        off = self.asked.off([looks.patch(number) for number in marked])
        if not self._tells(lead) or off > _NEAR_IN_PICTURES:
            found = "the patches fit by {:.0f} and {:.0f}".format(*misfits)
            raise Rejected("cues", f"{found}, and are off by {off:.0f}")
        measures = {"patch_lead": lead, "patch_best": min(misfits), "patch_off": off}
        model = reference or marked[self.asked.right]
        for light in looks.lights:
            a, b, like = (looks.main(number, light) for number in (*marked, model))
            self._check_light(light, a, b, like)
            measures[f"apart_{light}"] = float(ciede2000(a, b))
        return measures

    def _check_light(self, light: str, a: Array, b: Array, model: Array) -> None:
        """That main colours, CIELAB, shape (3,) each, give the right answer."""
        try:
            found = which_darker(a, b) if self.plan.form == "darker" else which_like(a, b, model)
        except ValueError as error:
            raise Rejected("light", f"{light}: {error}") from error
        if found != PAIR[self.asked.right]:
            raise Rejected("light", f"the other one fits in {light}")

    def _tells(self, lead: float) -> bool:
        """Whether a lead of the right thing's patch is as planned, and could be seen."""
        return leads_enough(self.plan.form, lead) and (lead > 0) == self.plan.cues[0]

    def _off(self, a: _Patch, b: _Patch) -> float:
        """How far patches of A and B are from what is to show; infinity if they tell otherwise."""
        labs: Sequence[Array] = a.lab, b.lab
        lead = self.asked.lead([float(misfit(self.plan.form, lab, self.colour)) for lab in labs])
        right, wrong = (b, a) if self.asked.right else (a, b)
        if not self._tells(lead) or (right.area_px > wrong.area_px) != self.plan.cues[1]:
            return math.inf
        off = self.asked.off(labs)
        return off if off <= NEAR else math.inf
