"""Furniture to sit at, a plant and a radiator, for a room behind a table."""

from __future__ import annotations

import numpy as np

from probe.assets.environments.pieces import (
    BRIGHT,
    CLOTHS,
    LEAVES,
    PAINTED,
    WOODS,
    Boxes,
    box,
    moved,
    one_of,
    things,
)


def sofa(rng: np.random.Generator) -> Boxes:
    """A sofa or an armchair with cushions."""
    wide, cloth = float(rng.uniform(0.8, 1.7)), one_of(rng, CLOTHS)
    made = [
        box((0, 0.05, 0.08), (wide, 0.85, 0.3), cloth),
        box((0, 0.05, 0.3), (wide, 0.3, 0.85), one_of(rng, (cloth,))),
        box((0, 0.05, 0.2), (0.16, 0.88, 0.62), cloth),
        box((wide - 0.16, 0.05, 0.2), (wide, 0.88, 0.62), cloth),
    ]
    seats = max(1, round(wide / 0.75))
    inner = (wide - 0.36) / seats
    for k in range(seats):
        left = 0.18 + inner * k
        made.append(
            box((left, 0.25, 0.28), (left + inner - 0.01, 0.87, 0.46), one_of(rng, (cloth,)))
        )
        if rng.random() < 0.85:
            pillow = one_of(rng, BRIGHT + CLOTHS)
            made.append(box((left + 0.05, 0.25, 0.42), (left + 0.5, 0.5, 0.82), pillow, round=True))
    return made


def chair(rng: np.random.Generator) -> Boxes:
    """A chair; its back is towards the viewer."""
    colour = one_of(rng, WOODS + CLOTHS + PAINTED)
    seat = one_of(rng, (colour, *CLOTHS[:3]))
    made = [box((0, 0, 0.43), (0.42, 0.42, 0.48), seat)]
    made += [
        box((u, v, 0), (u + 0.035, v + 0.035, 0.43), colour)
        for u in (0.0, 0.385)
        for v in (0.0, 0.385)
    ]
    made += [box((u, 0.39, 0.48), (u + 0.035, 0.42, 0.92), colour) for u in (0.0, 0.385)]
    if rng.random() < 0.5:
        return [*made, box((0.03, 0.395, 0.58), (0.39, 0.415, 0.92), seat)]
    return made + [
        box((0.02, 0.395, z), (0.4, 0.415, z + 0.05), colour) for z in (0.58, 0.71, 0.85)
    ]


def desk(rng: np.random.Generator) -> Boxes:
    """A desk with a screen on it and a chair before it."""
    wide, top = float(rng.uniform(1.2, 1.7)), one_of(rng, WOODS + PAINTED[:3])
    made = [box((0, 0, 0.7), (wide, 0.7, 0.74), top)]
    made += [
        box((u, v, 0), (u + 0.05, v + 0.05, 0.7), "#5a5c5e")
        for u in (0.03, wide - 0.08)
        for v in (0.05, 0.6)
    ]
    made.append(box((wide - 0.5, 0.1, 0.1), (wide - 0.1, 0.65, 0.62), one_of(rng, PAINTED)))
    middle = float(rng.uniform(0.4, wide - 0.5))
    made.append(box((middle - 0.3, 0.2, 0.84), (middle + 0.3, 0.23, 1.2), "#17191c"))
    made.append(box((middle - 0.1, 0.12, 0.74), (middle + 0.1, 0.3, 0.76), "#2a2c2e"))
    made += things(rng, (0.08, middle - 0.3), 0.74, 0.25)
    return made + moved(chair(rng), middle - 0.2, 0.75)


def plant(rng: np.random.Generator) -> Boxes:
    """A large plant in a pot."""
    pot, high = float(rng.uniform(0.28, 0.4)), float(rng.uniform(0.9, 1.7))
    made = [
        box(
            (0.1, 0.1, 0),
            (0.1 + pot, 0.1 + pot, pot),
            one_of(rng, ("#b5643f", "#e8e4dc", "#55595c")),
        )
    ]
    middle = 0.1 + pot / 2
    for _ in range(int(rng.integers(10, 18))):
        turn, out = rng.uniform(0, 2 * np.pi), rng.uniform(0.05, 0.3)
        u, v = (float(middle + out * part) for part in (np.cos(turn), np.sin(turn)))
        z, size = float(rng.uniform(pot + 0.1, high)), float(rng.uniform(0.09, 0.2))
        low, top = (
            (u - size, max(v - size, 0.01), z - size * 0.5),
            (u + size, v + size, z + size * 0.5),
        )
        made.append(box(low, top, one_of(rng, LEAVES), round=True))
    return made


def radiator(rng: np.random.Generator) -> Boxes:
    """A radiator's ribs."""
    ribs = int(rng.integers(9, 16))
    return [
        box((0.09 * k, 0.04, 0.14), (0.09 * k + 0.055, 0.13, 0.72), "#eeeeec") for k in range(ribs)
    ]
