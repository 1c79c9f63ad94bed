"""Lays a cover over a thing and another one over both, on the bare table."""

from __future__ import annotations

import math

import numpy as np

from probe.generation.covers import Cover
from probe.generation.object_selection import ObjectSelection
from probe.generation.result import Rejected
from probe.generation.stage import Layer, Poses, Stage, about_z
from probe.types import Array, Pose
from probe.world.model import Post

_TRIES = 6
_AIM = 0.004
_SHARE = 0.95
"""Share of a thing's corners that lie beneath its cover."""


def build_stack(
    cast: ObjectSelection, stage: Stage, target: int, at: Post, rng: np.random.Generator
) -> Poses:
    """Hide a target beneath the first cover, and both beneath the second.

    Args:
        cast: Has the covers, the inner one first.
        stage: Has all of them.
        target: Instance of what is at the bottom.
        at: Its middle.
        rng: Draws how the covers lie.

    Raises:
        Rejected: One of them doesn't hide what it should; they don't fit each other.
    """
    inner, outer = cast.covering
    share = 0.0
    for _ in range(_TRIES):
        poses = stage.nest(target, _layers(cast, rng), at)
        pairs = ((target, inner), (inner, outer))
        share = min(stage.covered_share(low, high, poses) for low, high in pairs)
        if share >= _SHARE and not stage.jammed:
            return poses
    names = " beneath ".join(cover.spec.name for cover in cast.covers)
    raise Rejected("nest", f"{names}: {share:.0%} is covered")


def _layers(cast: ObjectSelection, rng: np.random.Generator) -> list[Layer]:
    (below, above), (inner, outer) = cast.covers, cast.covering
    off: Array = rng.uniform(-_AIM, _AIM, size=2)
    turn = float(rng.uniform(0, 2 * math.pi))
    # The upper one lies over the lower one's middle, which isn't that of its cavity.
    aside = rng.uniform(-_AIM, _AIM, size=2) - _turned(below, turn)
    return [
        Layer(inner, below, off, turn),
        Layer(outer, above, off + aside, float(rng.uniform(0, 2 * math.pi))),
    ]


def _turned(cover: Cover, turn: float) -> Array:
    """From the middle of a cover's extent to that of its cavity, as it lies, shape (2,)."""
    return Pose(wxyz=about_z(turn)).apply(np.array([[*cover.middle, 0.0]]))[0, :2]
