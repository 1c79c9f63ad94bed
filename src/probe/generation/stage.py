"""Puts things on a table so that some are beneath others, and lets physics settle them."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.spatial import ConvexHull

from probe.assets.library import Library
from probe.assets.spec import ObjectSpec
from probe.errors import Unsatisfiable
from probe.generation.covers import Cover, on_side
from probe.generation.result import Rejected
from probe.scene.sampling import Drop, draw_drop
from probe.scene.setup import Setup
from probe.tasks.truth import ON_SHARE
from probe.types import Array, Pose, Quaternion
from probe.world.model import Item, Post
from probe.world.pile import SINK_LIMIT, Pile
from probe.world.rest import clear, rest, stand, unrest
from probe.world.settle import SETTLING_TIME

Poses = dict[int, Pose]
"""world_from_object by instance of a stage."""

_NEST_TIME = 2.0
_NEST_CHECK_TIME = 0.1
_FALL_TIME = 0.8
_LIFTED_TIME = 1.0
_RESPOTS = 3
_SPOT_TRIES = 40
_NARROWEST = 0.08
_REACH = 0.17
_RESPOT_REACH = 0.11
_TOPPING_TRIES = 4
_TOPPING_AIM = 0.01


@dataclass(frozen=True, eq=False)
class Layer:
    """A cover and how it is laid over something.

    Attributes:
        instance: Its own, on a stage.
        cover: How it lies.
        off: (x, y) in metres from the middle of what it covers to where its own middle, or that
            of its cavity, is aimed.
        turn: About the vertical, radians.
    """

    instance: int
    cover: Cover
    off: Array
    turn: float


class Stage:
    """All objects that any twin of a scene needs; only those given poses are on the table."""

    def __init__(
        self, specs: Sequence[ObjectSpec], library: Library, posts: Sequence[Post], setup: Setup
    ) -> None:
        self._setup = setup
        self._posts = tuple(posts)
        self.items = [Item(n, spec, library.form(spec.id)) for n, spec in enumerate(specs, start=1)]
        self._pile = Pile(self.items, posts, setup)
        self._corners = {
            item.instance: np.concatenate([piece.vertices for piece in item.body.pieces])
            for item in self.items
        }

    def nest(self, target: int, layers: Sequence[Layer], at: Post, *, laid: bool = False) -> Poses:
        """Put a target on the bare table and covers over it; where all come to rest.

        The target is turned at right angles where that lays its long side along that of the
        lowest cover.

        Args:
            target: Instance of what is to be hidden.
            layers: At least one, the lowest first.
            at: Middle of the target.
            laid: Whether the target lies on its longer side instead of standing.
        """
        clear(self._pile)
        turned = about_z(layers[0].turn + self._crosswise(target, layers[0].cover))
        if laid:
            tipped = (Pose(wxyz=turned) @ Pose(wxyz=on_side(self.items[target - 1].spec))).wxyz
            self._pile.drop(target, Drop(at.x, at.y, tipped))
            self._pile.fall(_NEST_TIME)
        else:
            self._pile.place(target, Pose((at.x, at.y, 0.0), turned))
        for layer in layers:
            spin = Pose(wxyz=about_z(layer.turn))
            middle = spin.apply(np.array([[*layer.cover.middle, 0.0]]))[0, :2]
            x, y = np.array([at.x, at.y]) + layer.off - middle
            wxyz = (spin @ Pose(wxyz=layer.cover.wxyz)).wxyz
            self._pile.drop(layer.instance, Drop(float(x), float(y), wxyz))
            self._pile.fall(_NEST_TIME)
        self._pile.stay_awake(awake=True)
        self._pile.step(_NEST_CHECK_TIME)
        self._pile.stay_awake(awake=False)
        return self._poses()

    def turn_under(self, target: int, cover: Cover, yaw: float) -> float:
        """The turn of a lowest cover under which nest() gives a target this yaw, radians."""
        return yaw - self._crosswise(target, cover)

    def _crosswise(self, target: int, cover: Cover) -> float:
        size = self.items[target - 1].spec.size
        crosswise = (size[0] > size[1]) != (cover.extent[0] > cover.extent[1])
        return math.pi / 2 if crosswise else 0.0

    @property
    def jammed(self) -> bool:
        """Whether things overlap more than things at rest may, after nest()."""
        return self._pile.penetration() > SINK_LIMIT

    def covered_share(self, target: int, covering: int, poses: Poses) -> float:
        """Share of a target's corners that lie straight beneath a cover and lower than its top."""
        low = poses[target].apply(self._corners[target])
        high = poses[covering].apply(self._corners[covering])
        edges = ConvexHull(high[:, :2]).equations
        outside = (low[:, :2] @ edges[:, :2].T + edges[:, 2]).max(axis=1)
        return float(((outside <= 0) & (low[:, 2] < high[:, 2].max())).mean())

    def heap(self, placed: Poses, dropped: Sequence[int], rng: np.random.Generator) -> Poses:
        """Drop more things around what is placed and held there; settle() still has to follow.

        Args:
            placed: Where some things are.
            dropped: Instances that fall, in this order.
            rng: Draws spots and orientations.

        Raises:
            Rejected: Not all of them rest on the table.
        """
        clear(self._pile)
        for instance, pose in placed.items():
            self._pile.place(instance, pose)
        self._pile.hold(*placed)
        waiting = list(dropped)
        for respot in range(_RESPOTS + 1):
            reach = _RESPOT_REACH if respot else _REACH
            self._pile.set_walls(standing=True)
            for instance in waiting:
                spec = self.items[instance - 1].spec
                drop = draw_clear_drop(spec, self._posts, reach, rng, self._setup.work_area)
                self._pile.drop(instance, drop)
                self._pile.fall(_FALL_TIME)
            self._pile.set_walls(standing=False)
            self._pile.fall(SETTLING_TIME)
            waiting = [instance for instance in dropped if not self._pile.is_inside(instance)]
            if not waiting:
                break
            for instance in waiting:
                self._pile.park(instance)
        if waiting:
            raise Rejected("settle", f"{len(waiting)} keep leaving the table")
        return self._poses()

    def top(self, toppings: Mapping[int, int], rng: np.random.Generator) -> Poses:
        """Lay things, or none, on others that heap() holds; settle() still has to follow.

        Args:
            toppings: Instances that fall, each with the one that it falls on.
            rng: Draws spots and orientations.

        Raises:
            Rejected: One of them slides off.

        Returns:
            Where all are.
        """
        for instance, beneath in toppings.items():
            for _ in range(_TOPPING_TRIES):
                corners = self._pile.pose(beneath).apply(self._corners[beneath])
                middle = (corners.min(axis=0) + corners.max(axis=0))[:2] / 2
                x, y = (float(v) for v in middle + rng.uniform(-_TOPPING_AIM, _TOPPING_AIM, size=2))
                turn = about_z(float(rng.uniform(0, 2 * math.pi)))
                self._pile.drop(instance, Drop(x, y, turn))
                self._pile.fall(SETTLING_TIME)
                if self.lies_on(instance, beneath, self._poses()):
                    break
                self._pile.park(instance)
            else:
                below = self.items[beneath - 1].spec.name
                name = self.items[instance - 1].spec.name
                raise Rejected("topping", f"{name} slides off {below}")
        return self._poses()

    def lies_on(self, instance: int, beneath: int, poses: Poses) -> bool:
        """Whether most of a thing is straight above another one, and its top is higher."""
        high = poses[instance].apply(self._corners[instance])
        low = poses[beneath].apply(self._corners[beneath])
        edges = ConvexHull(low[:, :2]).equations
        outside = (high[:, :2] @ edges[:, :2].T + edges[:, 2]).max(axis=1)
        return bool((outside <= 0).mean() >= ON_SHARE and high[:, 2].max() > low[:, 2].max())

    def settle(self, poses: Poses) -> Poses:
        """Put things exactly here and let them come to rest by the rules of a scene.

        Raises:
            Rejected: They don't.
        """
        try:
            return rest(self._pile, poses)
        except Unsatisfiable as failure:
            raise Rejected("settle", str(failure)) from failure

    def unrest(self, poses: Poses) -> str | None:
        """What is wrong with the rest of things in these poses, for people; None if nothing is."""
        return unrest(self._pile, poses)

    def lift(self, poses: Poses, *instances: int) -> Poses:
        """Where the others end up when some things vanish."""
        stand(self._pile, {n: pose for n, pose in poses.items() if n not in instances})
        self._pile.step(_LIFTED_TIME)
        self._pile.stay_awake(awake=False)
        self._pile.fall(SETTLING_TIME)
        return self._poses()

    def _poses(self) -> Poses:
        return {instance: self._pile.pose(instance) for instance in self._pile.on_table}


def draw_clear_drop(
    spec: ObjectSpec,
    posts: Sequence[Post],
    reach: float,
    rng: np.random.Generator,
    work_area: float,
) -> Drop:
    """Draw a drop that stays clear of walls and posts; the clearest of many if none does.

    Args:
        spec: What falls.
        posts: Discs to keep off.
        reach: How far from the table's middle its own may be along x and y, metres.
        rng: Draws spots and orientations.
        work_area: Edge of the square that it mustn't leave, metres.
    """
    radius = math.hypot(*sorted(spec.size)[1:]) / 2
    reach = max(_NARROWEST, min(reach, work_area / 2 - radius))
    best, best_gap = draw_drop(rng, reach), -math.inf
    for _ in range(_SPOT_TRIES):
        drop = draw_drop(rng, reach)
        gaps = (math.hypot(drop.x - p.x, drop.y - p.y) - p.radius - radius for p in posts)
        gap = min(gaps, default=math.inf)
        if gap > best_gap:
            best, best_gap = drop, gap
        if gap >= 0:
            break
    return best


def about_z(angle: float) -> Quaternion:
    """A turn about the vertical, radians."""
    return (math.cos(angle / 2), 0.0, 0.0, math.sin(angle / 2))
