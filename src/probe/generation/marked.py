"""Scenes in which two marked things show a little each, beneath covers of their own."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.generation.alike import unlike
from probe.generation.covers import Cover, draw_shield, lies_on_side, low_footprint_of
from probe.generation.frame import SceneFrame
from probe.generation.in_view import check_open
from probe.generation.object_selection import draw_crowd
from probe.generation.result import Rejected
from probe.generation.scene_view import SceneView
from probe.generation.stage import Layer, Poses, Stage
from probe.generation.visibility_rules import is_little, is_seen
from probe.perception.outline import deepest_inside
from probe.render.renderer import Renderer
from probe.scene.scene import Scene
from probe.scene.setup import Setup
from probe.scene.visibility import Visibility
from probe.tasks.task import PAIR, Mark
from probe.types import Array
from probe.world.model import Post

INSIDE_PX = 6.0
"""Distance of a mark from the edge of what shows of its thing."""

SMALLEST, LARGEST = 0.04, 0.17
"""Longest sides of marked things, metres."""

MARKABLE = f"things of {100 * SMALLEST:g} to {100 * LARGEST:g} cm can be marked"

LARGEST_AROUND = 0.15
"""Longest side in metres of the others: there must be room beside two covers."""

_COUNT = 15
_SIDES = 2
_FROM_MIDDLE = 0.10
_KEEP_OFF = 1.1
_ASIDE = math.radians(80)
_BISECTIONS = 5


@dataclass(frozen=True, eq=False)
class MarkedSelection:
    """Who plays: the marked two, a cover for each, and all others."""

    marked: tuple[ObjectSpec, ObjectSpec]
    covers: tuple[Cover, Cover]
    others: tuple[ObjectSpec, ...]

    @property
    def specs(self) -> tuple[ObjectSpec, ...]:
        """All of them, in the order of their instances on a stage."""
        return (*self.marked, *(cover.spec for cover in self.covers), *self.others)


@dataclass(frozen=True, eq=False)
class CoveredThing:
    """One marked thing, partly beneath its cover on a bare table.

    Attributes:
        poses: Of both, by instance on the stage.
        seen: How much of the thing shows.
        labels: Instance numbers of the picture, shape (h, w).
        scene: The same as a scene.
    """

    poses: Poses
    seen: Visibility
    labels: Array
    scene: Scene


@dataclass(frozen=True, eq=False)
class LyingOut:
    """Which way a marked thing is moved out from under its cover, and how both lie.

    Attributes:
        out: Direction on the table, shape (2,), length 1.
        turn: Of the cover about the vertical, radians.
    """

    out: Array
    turn: float


@dataclass(frozen=True, eq=False)
class MarkedStage:
    """A stage with what looks at it."""

    cast: MarkedSelection
    stage: Stage
    posts: tuple[Post, Post]
    view: SceneView
    frame: SceneFrame

    @property
    def marked(self) -> tuple[int, int]:
        """The scene's numbers of the two that are marked."""
        return self.frame.number_of[1], self.frame.number_of[2]


def cast_marked(
    library: Library,
    pair: tuple[ObjectSpec, ObjectSpec],
    needed: Sequence[ObjectSpec],
    rng: np.random.Generator,
    unlike_too: Sequence[ObjectSpec] = (),
    *,
    closed: bool = False,
) -> MarkedSelection | None:
    """Draw covers that would both do for either of two marked things, and the others.

    Args:
        library: To choose from.
        pair: The two, A first.
        needed: What must be among the others; it is dropped last.
        rng: Draws the rest.
        unlike_too: What else all others have to be told apart from by name.
        closed: Whether covers with holes won't do.

    Returns:
        None if nothing covers them.

    Raises:
        Rejected: The library has too few others.
    """
    free = unlike(library.specs, [*pair, *needed, *unlike_too])
    room = [low_footprint_of(library, spec.id) for spec in pair]
    first = draw_shield(library, free, room, rng, closed=closed)
    second = first and draw_shield(library, unlike(free, [first.spec]), room, rng, closed=closed)
    if not first or not second:
        return None
    free = unlike(free, [first.spec, second.spec])
    free = [spec for spec in free if max(spec.size) <= LARGEST_AROUND]
    crowd = draw_crowd(free, _COUNT - 2 * _SIDES - len(needed), rng)
    return MarkedSelection(pair, (first, second), (*crowd, *needed))


def markable(library: Library) -> list[ObjectSpec]:
    """Objects of a size to be marked."""
    return [spec for spec in library.specs if SMALLEST <= max(spec.size) <= LARGEST]


def build_set(
    cast: MarkedSelection,
    seed: int,
    library: Library,
    renderer: Renderer,
    tables: Sequence[str],
    rng: np.random.Generator,
    setup: Setup,
    *,
    keep_off: bool = True,
) -> MarkedStage:
    """The stage of a cast: its two nests go on two sides of the middle.

    Args:
        cast: Who plays.
        seed: Of the scene.
        library: Has the cast.
        renderer: What was loaded in it is replaced.
        tables: Ids of tables to choose from.
        rng: Draws table, numbers and places.
        setup: What stands around.
        keep_off: Whether all others stay clear of the nests.
    """
    view = SceneView(renderer, library, [spec.id for spec in cast.specs], setup)
    table = tables[int(rng.integers(len(tables)))]
    angle = float(rng.uniform(0, 2 * math.pi))
    distance = max(_FROM_MIDDLE, sum(cover.reach for cover in cast.covers) / 2)
    sides = [angle, angle + math.pi]
    first, second = (
        Post(distance * math.cos(turn), distance * math.sin(turn), cover.reach * _KEEP_OFF)
        for turn, cover in zip(sides, cast.covers, strict=True)
    )
    posts = first, second
    frame = SceneFrame.of(cast.specs, seed, table, rng, setup)
    return MarkedStage(
        cast, Stage(cast.specs, library, posts if keep_off else (), setup), posts, view, frame
    )


def peeks(
    made: MarkedStage,
    place: int,
    wanted: float,
    rng: np.random.Generator,
    facing: float | None = None,
) -> list[CoveredThing]:
    """Move a thing out from under its cover until about so much of it shows.

    Args:
        made: The set.
        place: 0 for A, 1 for B.
        wanted: Visible share, 0 to 1.
        rng: Draws which way, and how both lie.
        facing: The side of the thing that is to look out, as its angle; None for any.

    Returns:
        All that was tried on the way and shows a little; not yet at rest.
    """
    way = draw_way_out(made, place, rng, facing)
    low, high = 0.0, furthest_out(made, place)
    found: list[CoveredThing] = []
    for _ in range(_BISECTIONS):
        middle = (low + high) / 2
        nest = moved_out(made, place, way, middle)
        if is_little(nest.seen) and not made.stage.jammed:
            found.append(nest)
        low, high = (middle, high) if nest.seen.fraction < wanted else (low, middle)
    return found


def draw_way_out(
    made: MarkedStage, place: int, rng: np.random.Generator, facing: float | None = None
) -> LyingOut:
    """A way out from under a thing's cover; see peeks()."""
    cover, post = made.cast.covers[place], made.posts[place]
    turn = float(rng.uniform(0, 2 * math.pi))
    # Outwards: towards the middle, the other nest might be in its place.
    towards = math.atan2(post.y, post.x) + float(rng.uniform(-_ASIDE, _ASIDE))
    if facing is not None:
        turn = made.stage.turn_under(place + 1, cover, towards - facing)
    return LyingOut(np.array([math.cos(towards), math.sin(towards)]), turn)


def furthest_out(made: MarkedStage, place: int) -> float:
    """How far a thing may be moved at most until its cover misses it, metres."""
    return made.cast.covers[place].reach + max(made.cast.marked[place].size) / 2


def moved_out(made: MarkedStage, place: int, way: LyingOut, distance: float) -> CoveredThing:
    """A thing so many metres out from under the middle of its cover; not yet at rest.

    The cover is laid over it there, and it may be jammed.
    """
    cover, spec, post = made.cast.covers[place], made.cast.marked[place], made.posts[place]
    x, y = np.array([post.x, post.y]) + distance * way.out
    layer = Layer(_SIDES + place + 1, cover, -distance * way.out, way.turn)
    at = Post(float(x), float(y), post.radius)
    return _look(made, place, made.stage.nest(place + 1, [layer], at, laid=lies_on_side(spec)))


def _look(made: MarkedStage, place: int, poses: Poses) -> CoveredThing:
    scene = made.frame.scene(poses)
    number = made.frame.number_of[place + 1]
    labels = made.view.labels(scene)
    return CoveredThing(poses, made.view.visibility(scene, labels, [number])[number], labels, scene)


def at_rest(made: MarkedStage, place: int, nest: CoveredThing) -> CoveredThing | None:
    """The nest once all is still; None if its cover slides off before."""
    try:
        settled = _look(made, place, made.stage.settle(nest.poses))
    except Rejected:
        return None
    return settled if is_little(settled.seen) else None


def settle_around(
    made: MarkedStage, nests: Sequence[CoveredThing], rng: np.random.Generator
) -> Scene:
    """The crowd around both nests, all at rest.

    Raises:
        Rejected: They don't come to rest, or too much or too little shows of a marked thing.
    """
    poses = {instance: pose for nest in nests for instance, pose in nest.poses.items()}
    crowd = list(range(2 * _SIDES + 1, len(made.cast.specs) + 1))
    scene = made.frame.scene(made.stage.settle(made.stage.heap(poses, crowd, rng)))
    seen = made.view.visibility(scene, made.view.labels(scene), made.marked)
    for number in made.marked:
        # What is named goes with its size and colours.
        if not is_little(seen[number]) or is_seen(seen[number]):
            share, pixels = seen[number].fraction, seen[number].visible_px
            raise Rejected("shows", f"{share:.0%}, {pixels} px of a marked thing show")
    return scene


def settle_open(made: MarkedStage, rng: np.random.Generator) -> Scene:
    """Everything in one pile, covers included, with both marked things in plain view.

    Raises:
        Rejected: They aren't, or things don't come to rest.
    """
    others = list(range(_SIDES + 1, len(made.cast.specs) + 1))
    poses = made.stage.heap({}, [*others, *range(1, _SIDES + 1)], rng)
    scene = made.frame.scene(made.stage.settle(poses))
    check_open(scene, made.view, made.marked)
    return scene


def draw_marks(made: MarkedStage, labels: Array) -> tuple[Mark, Mark]:
    """Marks where the visible parts are widest.

    Raises:
        Rejected: One is too narrow anywhere.
    """
    first, second = (
        Mark(letter, number, widest(labels == number))
        for letter, number in zip(PAIR, made.marked, strict=True)
    )
    return first, second


def widest(mask: Array) -> tuple[int, int]:
    """Pixel (u, v) furthest from the edge of a mask, shape (h, w), and of the picture.

    Raises:
        Rejected: The mask is too narrow for a mark anywhere.
    """
    point, depth = deepest_inside(mask) if mask.any() else ((0, 0), 0.0)
    if depth < INSIDE_PX:
        raise Rejected("mark", f"a marked thing shows by a strip of {2 * depth:.0f} px")
    return point
