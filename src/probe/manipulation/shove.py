"""A short push of a thing that only its neighbours keep from being gripped. Knows no names."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy import ndimage

from probe.manipulation.candidates import propose
from probe.manipulation.planning import GraspPlan
from probe.manipulation.push import ALONG, Direction
from probe.manipulation.recognition import found_again
from probe.manipulation.room import room_ahead
from probe.manipulation.stroke import stroke
from probe.manipulation.target import Target, target_of
from probe.manipulation.terrain import CELL, Terrain
from probe.scene.setup import Basket, Setup
from probe.station.colours import paintable
from probe.station.station import Hand, Station
from probe.types import Array, Camera, Frame

DISTANCE = 0.05
"""How far it is to go, metres."""

_FINGERS = 0.02
_NEAR, _BESIDE = 1, 3
_BARE = 0.006
_FREE_BORDER, _WHOLE = 0.5, 0.9


@dataclass(frozen=True, eq=False)
class Shove:
    """A push that came before a grasp.

    Attributes:
        direction: Where to, in the fixed camera's picture.
        moved: How far the thing went that way, by its looks, metres; None if it wasn't found again.
        frame: The table afterwards.
        mask: Which of its pixels show the thing, bool, shape (h, w); None if it wasn't found again.
    """

    direction: Direction
    moved: float | None
    frame: Frame
    mask: Array | None


def shove(station: Station, plan: GraspPlan, mask: Array, setup: Setup) -> Shove | None:
    """Push a thing once towards where least stands, and find it again.

    The hand itself may meet nothing else on its way: through a heap it would take the heap along.
    The arm starts and ends parked.

    Args:
        station: The arm, camera and table.
        plan: In which no grasp of the thing had a free route.
        mask: Which pixels of the plan's frame show it, bool, shape (h, w).
        setup: The table's; nothing is pushed into its basket, nor out of the picture.

    Returns:
        None where it would not help or the arm can't; then nothing was moved.
    """
    if not (stands_free(plan.target, plan.terrain) and _fits_alone(plan, mask, station.hand)):
        return None
    ways = emptiest(plan.target, plan.terrain, plan.frame.camera, setup.basket)
    before = plan.frame if not ways else paintable(station, plan.frame)
    for direction in ways:
        along = ALONG[direction]
        done = stroke(station, before, mask, along, DISTANCE, setup, clear=True)
        if done.end in ("no_space", "unreachable"):
            continue
        after, found = found_again(station, before, done.frame, mask, along * done.swept)
        if found is None:
            return Shove(direction, None, after, None)
        return Shove(direction, float(found.shift @ along), after, found.mask)
    return None


def stands_free(target: Target, terrain: Terrain) -> bool:
    """Whether a thing shows in one piece, with the bare table beside at least half of its edge.

    What lies on others drags them along when it is pushed, and so does what lies beneath them. A
    camera above sees neither; but either begins at the thing's edge.
    """
    numbers, count = ndimage.label(ndimage.binary_closing(target.cells, iterations=_NEAR))
    sizes = np.bincount(numbers[target.cells], minlength=count + 1)
    inner = ndimage.binary_dilation(target.cells, iterations=_NEAR)
    beside = ndimage.binary_dilation(target.cells, iterations=_BESIDE) & ~inner
    bare = terrain.heights[beside] < _BARE
    whole = float(sizes.max()) >= _WHOLE * float(sizes.sum())
    return bool(bare.size) and whole and float(bare.mean()) >= _FREE_BORDER


def _fits_alone(plan: GraspPlan, mask: Array, hand: Hand) -> bool:
    """Whether the open hand gets around it where nothing else stands: no push makes it smaller."""
    alone = replace(plan.terrain, heights=np.where(plan.target.cells, plan.terrain.heights, 0.0))
    return bool(propose(target_of(plan.frame, mask, alone), alone, hand))


def emptiest(target: Target, terrain: Terrain, camera: Camera, basket: Basket) -> list[Direction]:
    """Ways that neither leave the picture nor meet the basket, the emptiest first.

    What counts is how much stands where the thing would go, and beside that, where fingers would.
    """
    others = terrain.without(target.cells).heights
    room = ndimage.binary_dilation(target.cells, iterations=round(_FINGERS / CELL))
    filled: dict[Direction, float] = {}
    for direction, along in ALONG.items():
        u, v = camera.project(target.top + DISTANCE * along).T
        shows = (u > 0) & (u < camera.width_px) & (v > 0) & (v < camera.height_px)
        if shows.all() and room_ahead(target, terrain, along, basket) >= DISTANCE:
            filled[direction] = float(others[_swept(room, along)].sum())
    return sorted(filled, key=lambda direction: filled[direction])


def _swept(cells: Array, along: Array) -> Array:
    """Cells that some cells pass over on the way, bool, shape (nx, ny)."""
    x, y = (int(step) for step in along[:2])
    reach = round(DISTANCE / CELL)
    # What leaves the grid would come back on its other side, were there no border around it.
    bordered = np.pad(cells, reach)
    swept = bordered.copy()
    for k in range(1, reach + 1):
        swept |= np.roll(bordered, (k * x, k * y), axis=(0, 1))
    return swept[reach:-reach, reach:-reach]
