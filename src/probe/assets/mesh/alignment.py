"""Lay one cloud of points over another as well as a rigid motion can. Knows no meshes."""

from __future__ import annotations

import itertools

import numpy as np
from scipy.spatial import cKDTree

from probe.assets.collision.hulls import principal_axes
from probe.types import Array

_STEPS = 12
_KEPT = 4


def misfit(points: Array, other: Array) -> float:
    """Mean distance, metres, between neighbours of two clouds once one is laid over the other.

    Starts from the 24 ways in which the principal axes can be matched, right-handed, and refines
    the best by iterated closest points (Besl and McKay, PAMI 14(2), 1992).

    Args:
        points: Spread evenly over a surface, shape (n, 3), metres.
        other: Likewise, shape (m, 3).
    """
    here, there = points - points.mean(axis=0), other - other.mean(axis=0)
    tree = cKDTree(there)
    starts = [_axes(there).T @ turn @ _axes(here) for turn in _TURNS]
    thinned = here[:: max(1, len(here) // 200)]
    first = [float(np.mean(tree.query(thinned @ start.T)[0])) for start in starts]
    best = np.argsort(first, kind="stable")[:_KEPT]
    return min(_refined(here, there, tree, starts[int(number)]) for number in best)


def _axes(points: Array) -> Array:
    """Principal axes, one a row, right-handed."""
    axes = principal_axes(points)
    return axes * np.array([[1.0], [1.0], [np.sign(np.linalg.det(axes))]])


def _refined(here: Array, there: Array, tree: cKDTree, start: Array) -> float:
    moved = here @ start.T
    for _ in range(_STEPS):
        nearest = there[tree.query(moved)[1]]
        moved = _laid_over(moved, nearest)
    forth = float(np.mean(tree.query(moved)[0]))
    back = float(np.mean(cKDTree(moved).query(there)[0]))
    return (forth + back) / 2


def _laid_over(points: Array, targets: Array) -> Array:
    """Points moved rigidly as close to their targets as possible (Arun and others, PAMI 9(5))."""
    middle, goal = points.mean(axis=0), targets.mean(axis=0)
    u, _, vt = np.linalg.svd((points - middle).T @ (targets - goal))
    mirrored = np.sign(np.linalg.det(u @ vt))
    turn = (u * [1.0, 1.0, mirrored]) @ vt
    return (points - middle) @ turn + goal


def _turns() -> list[Array]:
    """The 24 rotations of a cube."""
    found: list[Array] = []
    for order in itertools.permutations(range(3)):
        for signs in itertools.product((1.0, -1.0), repeat=3):
            turn = np.eye(3)[list(order)] * np.array(signs)[:, None]
            if np.linalg.det(turn) > 0:
                found.append(turn)
    return found


_TURNS = _turns()
