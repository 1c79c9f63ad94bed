"""Whether a hand fits between what is seen, on its way in and while it closes. Knows no arm."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from probe.manipulation.handshape import HandShape
from probe.manipulation.pairs import HandPoses
from probe.manipulation.target import Target
from probe.manipulation.terrain import Terrain
from probe.types import Array

BACK_OFF = 0.10
"""Length of the straight approach, metres."""

TIP_CLEARANCE = 0.0015
"""Metres that the finger tips stay above whatever is beneath them."""

_OPENING_STEP = 0.004
_DEPTHS = np.array([24, 10, -2, -12, -19, -24, -28, -30.5]) / 1000
_DEEPER = np.array([6, 3, 1.5]) / 1000
_SHIFTS = np.array([0, 8, -8]) / 1000
_BACK = np.array([0.0, 0.015, 0.03, 0.045, 0.07, BACK_OFF])


@dataclass(frozen=True)
class Margin:
    """How much room a hand is to have.

    Attributes:
        side: Metres between the hand and all that is seen.
        spread: Metres by which the open pads are further apart than what they close on.
        press: Metres that all but the pads' ends may come in below the edges of what they pass.
    """

    side: float
    spread: float
    press: float = 0.0


MARGINS = (
    Margin(0.002, 0.028),
    Margin(0.002, 0.014),
    Margin(0.0, 0.008),
    Margin(0.0, 0.008, 0.010),
    Margin(0.0, 0.006, 0.020),
)
"""From comfortable to tight; the last ones push neighbours aside with the fingers' backs."""


@dataclass(frozen=True, eq=False)
class Clearance:
    """Collision checks of a hand at one margin.

    Attributes:
        shape: The gripper's.
        margin: How much room it is to have.
        full: All that is seen, grown by the margin.
        bare: The same without the target.
    """

    shape: HandShape
    margin: Margin
    full: Terrain
    bare: Terrain

    @staticmethod
    def of(shape: HandShape, margin: Margin, terrain: Terrain, target: Target) -> Clearance:
        """The checks among what a terrain shows around a target."""
        bare = terrain.without(target.cells)
        if margin.side == 0:
            return Clearance(shape, margin, terrain, bare)
        return Clearance(shape, margin, terrain.widened(margin.side), bare.widened(margin.side))

    def openings(self, widths: Array) -> Array:
        """How far apart the pads are on their way to a width, metres, shape (n,)."""
        stepped = np.ceil((widths + self.margin.spread) / _OPENING_STEP) * _OPENING_STEP
        return np.minimum(stepped, self.shape.hand.max_opening)

    def deepest(self, hands: HandPoses) -> tuple[HandPoses, Array]:
        """Hands moved along their approach as deep as the pads may go; others are left out.

        A hand that fits nowhere is also tried a little to the side, so that the pads hold with
        their edges.

        Returns:
            The hands, and the index that each had, shape (n,).
        """
        centres = hands.centres.copy()
        waiting = np.arange(len(centres))
        settled = np.zeros(len(centres), bool)
        for shift in _SHIFTS:
            for depth in _DEPTHS:
                offset = hands.rotations @ np.array([shift, 0.0, depth])
                moved = replace(hands, centres=hands.centres + offset)
                free = waiting[self._tips_free(moved[waiting])]
                centres[free] = moved.centres[free]
                settled[free] = True
                waiting = waiting[~settled[waiting]]
        deep = self._lowered(replace(hands, centres=centres)[settled])
        return deep, np.flatnonzero(settled)

    def _lowered(self, hands: HandPoses) -> HandPoses:
        """The same a little deeper wherever that is free as well."""
        for step in _DEEPER:
            deeper = replace(hands, centres=hands.centres + step * hands.rotations[:, :, 2])
            free = self._tips_free(deeper)[:, None]
            hands = replace(hands, centres=np.where(free, deeper.centres, hands.centres))
        return hands

    def way_free(self, hands: HandPoses) -> Array:
        """Whether hands can come in straight and close, bool, shape (n,)."""
        free = np.zeros(len(hands.widths), bool)
        openings = self.openings(hands.widths)
        for opening in np.unique(openings):
            points = self.shape.whole(float(opening))
            for index in np.flatnonzero(openings == opening):
                one = hands[np.array([index])]
                free[index] = self._comes_in(one, points) and self._closes(one, float(opening))
        return free

    def _comes_in(self, one: HandPoses, points: Array) -> bool:
        reach = self.shape.hand.pad_reach(float(one.widths[0]))
        along = one.rotations[0, :, 2]
        ways = replace(
            one,
            rotations=np.repeat(one.rotations, len(_BACK), axis=0),
            centres=one.centres - (_BACK[:, None] + reach) * along,
        )
        return bool(_clear(self.full, points, ways, self.margin.press).all())

    def _closes(self, one: HandPoses, opening: float) -> bool:
        width = float(one.widths[0])
        swept = self.shape.swept(opening, width) - [0.0, 0.0, self.shape.hand.pad_reach(width)]
        return bool(_clear(self.bare, swept, one, self.margin.press)[0])

    def _tips_free(self, hands: HandPoses) -> Array:
        """Whether the tips stay above all when open and above the rest when closed, shape (n,)."""
        free = np.zeros(len(hands.widths), bool)
        openings = self.openings(hands.widths)
        for opening in np.unique(openings):
            group = np.flatnonzero(openings == opening)
            width = max(float(opening) - self.margin.spread, 0.0)
            group = group[_clear(self.full, self._tips(float(opening), width), hands[group])]
            free[group] = _clear(self.bare, self._tips(width, width), hands[group])
        return free

    def _tips(self, opening: float, width: float) -> Array:
        """Points on the pads' ends from the middle between them when they touch at a width."""
        return self.shape.tips(opening) - [0.0, 0.0, self.shape.hand.pad_reach(width)]


def _clear(terrain: Terrain, points: Array, hands: HandPoses, press: float = 0.0) -> Array:
    """Whether points in each hand's frame, from its centre, lie above the terrain, shape (n,)."""
    world = np.matmul(points, hands.rotations.transpose(0, 2, 1)) + hands.centres[:, None]
    return (world[..., 2] > terrain.below(world) + TIP_CLEARANCE - press).all(axis=1)
