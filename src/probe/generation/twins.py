"""Scenes in which any of five alike things could be the one that is hidden."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from probe.assets.spec import ObjectSpec
from probe.generation.covers import Cover
from probe.generation.frame import SceneFrame
from probe.generation.object_selection import ObjectSelection
from probe.generation.result import Rejected
from probe.generation.stage import Layer, Poses, Stage
from probe.generation.visibility_rules import is_hidden
from probe.scene.scene import Scene
from probe.scene.visibility import Visibility
from probe.types import Array
from probe.world.model import Post

_NEST_TRIES = 6
_NEST_SHARE = 0.95
_NEST_REACH = 0.06
_AIM = 0.004

Lay = Callable[[ObjectSpec, np.random.Generator], list[Layer]]
"""Draws how covers lie over a thing, the lowest first."""

Nest = Callable[[int], Poses]
"""Puts a thing, by its instance on a stage, and what hides it on the bare table; where they rest.

Raises Rejected where it stays in the open."""


@dataclass(frozen=True, eq=False)
class Twin:
    """A settled scene with one of the candidates in the hidden place.

    Attributes:
        candidate: Which one.
        poses: Of everything, by instance on the stage.
        scene: The same with the scene's own numbers.
    """

    candidate: int
    poses: Poses
    scene: Scene


def draw_post(covers: Sequence[Cover], wider: float, rng: np.random.Generator) -> Post:
    """Draw where something is covered: near the middle, so that the others lie all around it.

    Args:
        covers: What goes there.
        wider: How much wider than the covers the disc is that the others are kept off.
        rng: Draws the place.
    """
    x, y = (float(v) for v in rng.uniform(-_NEST_REACH, _NEST_REACH, size=2))
    return Post(x, y, max(cover.reach for cover in covers) * wider)


def build_nest(
    stage: Stage,
    target: int,
    lay: Lay,
    at: Post,
    rng: np.random.Generator,
    hiding: int = 1,
) -> Poses:
    """Hide a target beneath covers on the bare table.

    Args:
        stage: Has all of them.
        target: Instance of what is hidden.
        lay: Draws how the covers lie.
        at: Middle of the target.
        rng: Draws.
        hiding: How many of the covers, from the lowest on, must each hide it.

    Raises:
        Rejected: It stays in the open; they don't fit each other.
    """
    hidden = stage.items[target - 1].spec
    share, layers = 0.0, list[Layer]()
    for _ in range(_NEST_TRIES):
        layers = lay(hidden, rng)
        poses = stage.nest(target, layers, at)
        shares = [stage.covered_share(target, y.instance, poses) for y in layers[:hiding]]
        share = min(shares)
        if share >= _NEST_SHARE and not stage.jammed:
            return poses
    names = " and ".join(layer.cover.spec.name for layer in layers[:hiding])
    raise Rejected("nest", f"{names} covers {share:.0%} of {hidden.name}")


def check_hidden(seen: Visibility) -> None:
    """See that a thing shows too little to be noticed.

    Raises:
        Rejected: It shows more.
    """
    if not is_hidden(seen):
        raise Rejected("hidden", f"{seen.fraction:.0%}, {seen.visible_px} px")


def check_toppings(toppings: Mapping[int, int], stage: Stage, poses: Poses) -> None:
    """See that what is to lie on covers does, at rest.

    Raises:
        Rejected: Something slid off.
    """
    for topping, below in toppings.items():
        if not stage.lies_on(topping, below, poses):
            name, under = (stage.items[number - 1].spec.name for number in (topping, below))
            raise Rejected("topping", f"{name} slid off {under}")


def right_above(covering: int, cover: Cover) -> Lay:
    """Lays one cover right above what it hides, turned at random."""

    def lay(hidden: ObjectSpec, rng: np.random.Generator) -> list[Layer]:
        off: Array = rng.uniform(-_AIM, _AIM, size=2)
        return [Layer(covering, cover, off, float(rng.uniform(0, 2 * math.pi)))]

    return lay


def draw_twins(
    cast: ObjectSelection,
    stage: Stage,
    nest: Nest,
    check: Callable[[Twin], None],
    frame: SceneFrame,
    rng: np.random.Generator,
) -> tuple[Twin, ...]:
    """Settle the scene with each candidate in the hidden place; all must pass.

    The crowd is dropped around the first, which is held, and what lies on covers onto it; then each
    in turn takes its place, as it rests with what hides it on a bare table, and everything settles
    freely.

    Args:
        cast: Who plays.
        stage: Made of the cast's specs.
        nest: Hides a candidate, by its instance on the stage, on a bare table.
        check: Raises Rejected for a scene that breaks a rule.
        frame: Makes scenes of poses.
        rng: Draws spots, orientations and which candidate is first.

    Returns:
        The twins in the candidates' order.

    Raises:
        Rejected: Some twin doesn't settle or fails the check.
    """
    order = [int(index) for index in rng.permutation(len(cast.candidates))]
    nests: dict[int, Poses] = {}
    for index in order:
        nests[index] = nest(index + 1)
    stage.heap(nests[order[0]], cast.crowd, rng)
    poses = stage.top(cast.toppings, rng)
    crowd = {number: poses[number] for number in (*cast.crowd, *cast.toppings)}
    twins: dict[int, Twin] = {}
    for index in order:
        try:
            settled = stage.settle({**crowd, **nests[index]})
            check_toppings(cast.toppings, stage, settled)
            twins[index] = Twin(index, settled, frame.scene(settled))
            check(twins[index])
        except Rejected as failure:
            if index == order[0]:
                raise
            rejection = failure.rejection
            raise Rejected(f"twin {rejection.check}", rejection.detail) from failure
    return tuple(twins[index] for index in range(len(order)))
