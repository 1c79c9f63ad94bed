"""What is true of a starting scene of Relation, whatever happens later."""

from __future__ import annotations

import math
from collections.abc import Collection, Mapping, Sequence

import numpy as np

from probe.question_types.relation.rules import TURNS
from probe.scene.scene import PlacedObject, Scene
from probe.tasks.truth import Silhouette, beneath_each
from probe.tasks.type_rules import Form

RING = 3
"""Covers in a ring."""

MOST_ANGLE = math.radians(150)
"""Between neighbours of a ring, as seen from its middle: in a row it would be 180 degrees."""


def clockwise(points: Mapping[int, tuple[float, float]]) -> tuple[int, ...]:
    """Covers in the order in which one passes them going clockwise in a picture.

    Args:
        points: Their middles, pixels (u, v) with v downwards, by instance.

    Raises:
        ValueError: They don't lie around their common middle; the order would be unclear.
    """
    middle_u, middle_v = np.mean(list(points.values()), axis=0).tolist()
    # With v downwards angles grow clockwise.
    angles = {it: math.atan2(v - middle_v, u - middle_u) for it, (u, v) in points.items()}
    order = sorted(points, key=lambda number: angles[number])
    steps = [
        (angles[after] - angles[before]) % math.tau
        for before, after in zip(order, [*order[1:], order[0]], strict=True)
    ]
    if max(steps) > MOST_ANGLE:
        raise ValueError("The covers don't stand in a ring.")
    return tuple(order)


def next_along(form: Form, order: Sequence[int], start: int) -> int:
    """The next one of a ring.

    Args:
        form: One of TURNS.
        order: The ring's members, clockwise.
        start: From where.
    """
    step = 1 if form == TURNS[0] else -1
    return order[(order.index(start) + step) % len(order)]


def next_beneath(
    scene: Scene,
    form: Form,
    start: int,
    covers: Collection[int],
    silhouettes: Mapping[int, Silhouette],
) -> tuple[PlacedObject, int]:
    """What lies under the next cover of a ring, and that cover.

    Args:
        scene: The table at the start.
        form: One of TURNS: which way round.
        start: Instance of the thing under one of the covers from which one goes on.
        covers: Instances.
        silhouettes: Of everything on the table, by instance, as the picture shows it.

    Raises:
        ValueError: Not exactly one thing lies under each cover, or the named one under none, or
            the covers don't stand in a ring.
    """
    beneath = beneath_each(covers, silhouettes)
    if len(beneath) != RING or any(len(under) != 1 for under in beneath.values()):
        counts = [len(under) for under in beneath.values()]
        raise ValueError(f"Exactly one thing should lie under each of three covers, not {counts}.")
    over = [cover for cover, under in beneath.items() if under == (start,)]
    if not over:
        raise ValueError("The thing that is named lies under none of the covers.")
    order = clockwise({cover: _middle(silhouettes[cover]) for cover in covers})
    cover = next_along(form, order, over[0])
    return scene[beneath[cover][0]], cover


def _middle(silhouette: Silhouette) -> tuple[float, float]:
    v, u = np.nonzero(silhouette.mask)
    return float(u.mean()), float(v.mean())
