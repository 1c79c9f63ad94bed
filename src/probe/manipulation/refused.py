"""Hands that a planner of ours looked at and found no grasp in, and why. Knows no arm."""

from __future__ import annotations

from typing import Literal

import numpy as np

from probe.manipulation.candidates import Fitting, Grasp, Planner, fittings, grasp_of, propose
from probe.manipulation.edges import leaning, leaning_tries, pinch_tries, pinches
from probe.manipulation.pairs import HandPoses
from probe.manipulation.target import Target
from probe.manipulation.terrain import Terrain
from probe.station.station import Hand

Refusal = Literal["touching", "no_hold", "unchecked"]
"""Why a hand is no grasp:

touching: The hand would touch something, on its way in or while it closes.
no_hold: A pad would touch nothing, or it is too wide there.
unchecked: Enough better ones had been found; whether this one fits wasn't looked at.
"""


def refused(
    planner: Planner, target: Target, terrain: Terrain, hand: Hand
) -> list[tuple[Grasp, Refusal]]:
    """What a planner passes over in silence; none where it isn't ours.

    A hand that fits at some margin is a grasp and isn't among them. Of the ways to pinch an edge at
    one steepness the best one stands for all.
    """
    if planner is propose:
        hands, found = fittings(target, terrain, hand)
        return _misfits(hands, found)
    for ours, tries_of in ((leaning, leaning_tries), (pinches, pinch_tries)):
        if planner is ours:
            tried = tries_of(target, terrain, hand)
            seen = {each.place for each in tried if each.free}
            first = {each.place: each for each in reversed(tried) if each.place not in seen}
            return [(each.grasp, "touching") for each in first.values()]
    return []


def _misfits(hands: HandPoses, found: list[Fitting]) -> list[tuple[Grasp, Refusal]]:
    """Hands that fit at no margin, as they were at the last one."""
    last = found[-1]
    fit = {int(each.which[k]) for each in found for k in each.checked[each.free]}
    place = {int(number): k for k, number in enumerate(last.which)}
    checked = set(last.checked.tolist())
    refusals: list[tuple[Grasp, Refusal]] = []
    for number in range(len(hands.widths)):
        if number in fit:
            continue
        k = place.get(number)
        if k is None:
            refusals.append((grasp_of(last.room, hands, number, -np.inf), "touching"))
        elif not np.isfinite(last.merits[k]):
            refusals.append((last.grasp(k), "no_hold"))
        else:
            refusals.append((last.grasp(k), "touching" if k in checked else "unchecked"))
    return refusals
