"""What became of a thing between two looks at the table, by depth alone. Knows no names."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from scipy import ndimage

from probe.manipulation.terrain import lifted
from probe.types import Array, Frame

_Motion = tuple[float, float, float]

SAME = 0.003
"""Metres by which a pixel's depth may differ and still show the same."""

_POINTS = 250
_FOUND = 0.55
_SLACK = 0.15
_SLACK_LIMITS = (0.002, 0.008)
_SHIFT_COST = 4.0
_ROUGHLY = (np.arange(-8, 9) * 0.005, np.radians([-30.0, -15.0, 0.0, 15.0, 30.0]))
_FINELY = (np.arange(-3, 4) * 0.002, np.radians([-8.0, -4.0, 0.0, 4.0, 8.0]))
_STOPS = 0.06
_NOWHERE = np.zeros(3)


def still_there(before: Frame, after: Frame, mask: Array) -> float:
    """Share of a mask's pixels whose depth is as it was, 0 to 1."""
    change = np.abs(after.depth[mask] - before.depth[mask])
    return float(np.mean(change < SAME)) if change.size else 0.0


@dataclass(frozen=True, eq=False)
class Found:
    """A thing seen again.

    Attributes:
        mask: Which pixels show it, bool, shape (h, w).
        shift: How its middle moved over the table, metres, shape (3,).
    """

    mask: Array
    shift: Array


def tracked(before: Frame, after: Frame, mask: Array, way: Array = _NOWHERE) -> Found | None:
    """Find a thing again that may have slid and turned a little on the table.

    Args:
        before: Where the mask is known.
        after: Where it is looked for, up to 40 degrees turned and 4 cm beside the way.
        mask: bool, shape (h, w).
        way: A straight line from where it was, on which it may have stopped anywhere, metres,
            shape (3,).

    Returns:
        None if most of it isn't found.
    """
    points = lifted(before, mask)
    if len(points) == 0:
        return None
    few = points[:: max(1, len(points) // _POINTS)]
    # A tall thing may have tipped a little; a flat one would be taken for the table.
    slack = float(np.clip(_SLACK * points[:, 2].max(), *_SLACK_LIMITS))
    # What showed something else before, and shows it still, isn't the thing.
    possible = mask | (np.abs(after.depth - before.depth) > SAME)
    look = _Look(after, possible, few.mean(axis=0), slack)
    stops = math.ceil(float(np.linalg.norm(way)) / _STOPS) + 1
    places = [look.search(few, (*stop, 0.0), _ROUGHLY) for stop in np.linspace(0, way[:2], stops)]
    best, _ = max(places, key=lambda place: place[1])
    best, share = look.search(few, best, _FINELY)
    if share < _FOUND:
        return None
    uv, same = look.compared(points, best)
    found = np.zeros_like(mask, bool)
    columns, rows = uv[same].T
    found[rows, columns] = True
    return Found(ndimage.binary_closing(found, iterations=2), np.array([*best[:2], 0.0]))


@dataclass(frozen=True, eq=False)
class _Look:
    """A search for points in a frame.

    Attributes:
        frame: Where they are looked for.
        possible: Pixels that may show them, bool, shape (h, w).
        middle: What they turn about, shape (3,).
        slack: By how much a depth may differ, metres.
    """

    frame: Frame
    possible: Array
    middle: Array
    slack: float

    def search(
        self, points: Array, start: _Motion, steps: tuple[Array, Array]
    ) -> tuple[_Motion, float]:
        """The shift in x and y and the turn at which most points fit; and how many do."""
        best, best_merit, best_share = start, -math.inf, 0.0
        shifts, turns = steps
        for turn in start[2] + turns:
            for x in shifts:
                for y in shifts:
                    motion = (start[0] + float(x), start[1] + float(y), float(turn))
                    share = float(self.compared(points, motion)[1].mean())
                    merit = share - _SHIFT_COST * math.hypot(x, y)
                    if merit > best_merit:
                        best, best_merit, best_share = motion, merit, share
        return best, best_share

    def compared(self, points: Array, motion: _Motion) -> tuple[Array, Array]:
        """Pixels of moved points, int, shape (n, 2), and whether the frame shows them there."""
        camera = self.frame.camera
        placed = _moved(points - self.middle, motion) + self.middle
        uv = np.floor(camera.project(placed)).astype(int)
        inside = (uv >= 0).all(axis=1) & (uv < [camera.width_px, camera.height_px]).all(axis=1)
        uv = np.clip(uv, 0, [camera.width_px - 1, camera.height_px - 1])
        depth = camera.world_from_camera.inverse().apply(placed)[:, 2]
        shown = self.frame.depth[uv[:, 1], uv[:, 0]]
        possible = inside & self.possible[uv[:, 1], uv[:, 0]]
        return uv, possible & (np.abs(shown - depth) < self.slack)


def _moved(points: Array, motion: _Motion) -> Array:
    """Points turned about the vertical and shifted on the table."""
    x, y, turn = motion
    c, s = math.cos(turn), math.sin(turn)
    rotation = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    return points @ rotation.T + np.array([x, y, 0.0])
