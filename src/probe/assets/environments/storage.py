"""Furniture that holds things, for a room behind a table: shelves, cupboards, boxes."""

from __future__ import annotations

import numpy as np

from probe.assets.environments.pieces import (
    BRIGHT,
    PAINTED,
    WOODS,
    Boxes,
    box,
    one_of,
    things,
)


def shelf(rng: np.random.Generator) -> Boxes:
    """Open shelves with books and things."""
    wide, deep, high = float(rng.uniform(0.7, 1.3)), 0.3, float(rng.uniform(1.0, 2.0))
    wood = one_of(rng, WOODS + PAINTED)
    made = [box((0, 0, 0), (wide, 0.03, high), one_of(rng, (wood,)))]
    made += [box((u, 0, 0), (u + 0.03, deep, high), wood) for u in (0.0, wide - 0.03)]
    gap = float(rng.uniform(0.28, 0.4))
    for z in np.arange(0.05, high, gap).tolist():
        made.append(box((0, 0, z), (wide, deep, z + 0.03), wood))
        if z + gap < high:
            made += things(rng, (0.05, wide - 0.05), z + 0.03, gap - 0.06)
    return made


def cupboard(rng: np.random.Generator) -> Boxes:
    """A low cupboard with doors and handles, and a few things on it."""
    wide, deep, high = float(rng.uniform(1.1, 2.0)), 0.45, float(rng.uniform(0.6, 0.92))
    body = one_of(rng, WOODS + PAINTED)
    legs = float(rng.uniform(0.05, 0.16))
    made = [
        box((0, 0, legs), (wide, deep, high), body),
        box(
            (-0.01, 0, high), (wide + 0.01, deep + 0.02, high + 0.03), one_of(rng, (body, WOODS[0]))
        ),
    ]
    doors = int(rng.integers(2, 5))
    for k in range(doors):
        left, right = wide * k / doors + 0.012, wide * (k + 1) / doors - 0.012
        made.append(
            box((left, deep, legs + 0.02), (right, deep + 0.015, high - 0.02), one_of(rng, (body,)))
        )
        middle = (left + right) / 2
        made.append(
            box(
                (middle - 0.05, deep + 0.015, high - 0.09),
                (middle + 0.05, deep + 0.03, high - 0.07),
                "#c8c8c6",
            )
        )
    for u in (0.05, wide - 0.09):
        made.append(box((u, 0.05, 0), (u + 0.04, deep - 0.03, legs), one_of(rng, WOODS)))
    return made + things(rng, (0.1, wide * 0.8), high + 0.03, 0.3)[:: int(rng.integers(1, 3))]


def counter(rng: np.random.Generator) -> Boxes:
    """A kitchen's base units with an oven."""
    unit, count = 0.6, int(rng.integers(3, 6))
    front, top = one_of(rng, PAINTED + WOODS[:2]), one_of(rng, ("#3a3836", "#c8bfae", "#b48a5c"))
    wide = unit * count
    made = [
        box((0, 0, 0), (wide, 0.52, 0.1), "#2a2a2a"),
        box((0, 0, 0.1), (wide, 0.58, 0.86), one_of(rng, (front,))),
        box((0, 0, 0.86), (wide, 0.62, 0.9), top),
    ]
    oven = int(rng.integers(count))
    for k in range(count):
        left, right = unit * k + 0.006, unit * (k + 1) - 0.006
        if k == oven:
            made.append(box((left, 0.58, 0.14), (right, 0.6, 0.84), "#8c9092"))
            made.append(box((left + 0.05, 0.6, 0.2), (right - 0.05, 0.605, 0.62), "#15171a"))
        else:
            made.append(box((left, 0.58, 0.11), (right, 0.6, 0.7), front))
            made.append(box((left, 0.58, 0.71), (right, 0.6, 0.85), front))
        made.append(box((left + 0.12, 0.6, 0.76), (right - 0.12, 0.63, 0.78), "#d0d2d2"))
    return made + things(rng, (0.2, wide - 0.3), 0.9, 0.32)[::2]


def stack(rng: np.random.Generator) -> Boxes:
    """Cardboard boxes and crates on one another."""
    made: Boxes = []
    z = 0.0
    for _ in range(int(rng.integers(2, 4))):
        wide, high = float(rng.uniform(0.35, 0.6)), float(rng.uniform(0.22, 0.4))
        left = float(rng.uniform(0, 0.12))
        colour = one_of(rng, ("#b08d63", "#a98257", "#c29d70", *BRIGHT[1:4]))
        made.append(box((left, 0.05, z), (left + wide, 0.5, z + high), colour))
        made.append(
            box((left, 0.5, z + high * 0.45), (left + wide, 0.503, z + high * 0.55), "#d8c8a8")
        )
        z += high
    return made
