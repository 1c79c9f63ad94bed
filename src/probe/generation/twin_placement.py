"""Lays Compare's two things so that nothing shows of them but what their paint twins share."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from probe.assets.library import Library
from probe.generation.aimed_nests import draw_aimed
from probe.generation.marked import INSIDE_PX, CoveredThing, MarkedStage
from probe.generation.paint_twins import ALIKE, alike
from probe.generation.pairing import MOST, draw_nests
from probe.generation.result import Rejected
from probe.generation.scene_view import SceneView
from probe.generation.visibility_rules import LITTLE, LITTLE_PX
from probe.perception.outline import deepest_inside
from probe.scene.scene import Scene
from probe.types import Array

_ROOM = 1.2
_ROOM_PX = _ROOM * INSIDE_PX
"""Some of it may be lost to the crowd."""

_AIMED = 0.98
"""Least share of what shows that is alike in paint where it is aimed at; ALIKE in the end."""


def draw_unpainted(
    made: MarkedStage,
    twins: Sequence[str],
    library: Library,
    facing: tuple[Array, Array],
    more_of_a: bool,
    rng: np.random.Generator,
) -> tuple[CoveredThing, CoveredThing]:
    """Nests of both in which only what they share shows.

    Args:
        made: The set.
        twins: Ids of the paint twins of A and of B.
        library: Has them.
        facing: Angles of the sides of A and of B that may look out, radians.
        more_of_a: Whether more pixels of A are to show than of B.
        rng: Draws how they lie.

    Raises:
        Rejected: Nothing that was tried does.
    """

    def shown(place: int, nest: CoveredThing) -> int | None:
        if not _has_room(made, place, nest):
            return None
        return nest.seen.visible_px if _share(made, place, nest, twins, library) >= ALIKE else None

    def off(a: int, b: int) -> float:
        return 0.0 if (a > b) == more_of_a else math.inf

    return draw_nests(made, shown, off, rng, facing)


def aim_unpainted(
    made: MarkedStage,
    twins: Sequence[str],
    library: Library,
    facing: tuple[Array, Array],
    more_of_a: bool,
    rng: np.random.Generator,
) -> tuple[CoveredThing, CoveredThing]:
    """The same by newer rules, searched for by what is wrong with what shows.

    The arguments are those of draw_unpainted(), and so is what it raises.
    """

    def fit(place: int, nest: CoveredThing) -> int:
        seen = nest.seen
        if seen.fraction < _ROOM * LITTLE[0] or seen.visible_px < _ROOM * LITTLE_PX:
            return -1
        if seen.fraction > MOST or _share(made, place, nest, twins, library) < _AIMED:
            return 1
        return 0 if _has_room(made, place, nest) else -1

    return draw_aimed(made, fit, facing, more_of_a, rng)


def _has_room(made: MarkedStage, place: int, nest: CoveredThing) -> bool:
    """Whether what shows is wide enough for a mark."""
    return deepest_inside(nest.labels == made.marked[place])[1] >= _ROOM_PX


def _share(
    made: MarkedStage, place: int, nest: CoveredThing, twins: Sequence[str], library: Library
) -> float:
    """Of what shows, that which a thing shares with its twin; see shared()."""
    number = made.marked[place]
    return shared(made.view, nest.scene, nest.labels, number, twins[place], library)


def check_unpainted(
    made: MarkedStage,
    scene: Scene,
    labels: Array,
    twins: Sequence[str],
    library: Library,
    more_of_a: bool,
) -> None:
    """That it is still so once the crowd lies around them.

    Raises:
        Rejected: It isn't.
    """
    for number, twin in zip(made.marked, twins, strict=True):
        share = shared(made.view, scene, labels, number, twin, library)
        if share < ALIKE:
            raise Rejected("paint", f"{1 - share:.0%} of what shows tells a thing from its twin")
    a, b = (np.count_nonzero(labels == number) for number in made.marked)
    if (a > b) != more_of_a:
        raise Rejected("cues", "more of the other one shows than was planned")


def shared(
    view: SceneView, scene: Scene, labels: Array, number: int, twin: str, library: Library
) -> float:
    """Share of what shows of a thing on which its paint twin's paint is alike, 0 to 1.

    Args:
        view: Of the scene.
        scene: Has the thing.
        labels: Of the scene, shape (h, w).
        number: The thing's.
        twin: Object id of its twin.
        library: Has both.
    """
    face, weights = view.shown(scene, labels, number)
    if not len(face):
        return 0.0
    mesh = library.body(scene[number].object_id).mesh
    return float(alike(mesh, library.body(twin).mesh, face, weights).mean())
