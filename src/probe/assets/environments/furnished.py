"""What stands in a day room, along the wall ahead and before it."""

from __future__ import annotations

import numpy as np

from probe.assets.environments.pieces import Boxes, Make, moved
from probe.assets.environments.room import Furniture
from probe.assets.environments.seats import chair, desk, plant, radiator, sofa
from probe.assets.environments.shell import Shell
from probe.assets.environments.storage import counter, cupboard, shelf, stack

KINDS: tuple[tuple[Make, ...], ...] = (
    (shelf, cupboard, sofa, plant, radiator),
    (counter, cupboard, plant, radiator, shelf),
    (desk, shelf, cupboard, plant, stack),
    (stack, shelf, desk, counter, radiator),
    (sofa, shelf, cupboard, plant, radiator),
)
"""What stands in each kind of room; the first is there in any case."""

_BEYOND_TABLE = 1.85
"""Metres ahead of a front camera where the table has ended."""


def furnished(shell: Shell, kind: tuple[Make, ...], rng: np.random.Generator) -> list[Boxes]:
    """Furniture along the wall ahead, the first of a kind in any case, and chairs before it."""
    middle, wall = shell.stand[0], (shell.ahead + shell.behind) / 2
    made: list[Boxes] = []
    u = -min(shell.left, 2.4) + float(rng.uniform(0, 0.4))
    first = int(rng.integers(3))
    while u < min(shell.right, 2.4) - 0.4:
        make = kind[0] if len(made) == first else kind[int(rng.integers(len(kind)))]
        piece = make(rng)
        made.append(_placed(piece, middle + u, wall))
        u += max(it.high[0] for it in piece) + float(rng.uniform(0.05, 0.5))
    for _ in range(int(rng.integers(0, 3))):
        ahead = float(rng.uniform(_BEYOND_TABLE + 0.45, max(2.4, shell.ahead - 0.9)))
        place = moved(chair(rng), float(rng.uniform(-1.1, 0.8)), 0.0)
        made.append(_placed(place, middle, shell.stand[1] + ahead))
    return made


def _placed(piece: Boxes, x: float, wall: float) -> Boxes:
    """Where the boxes of a piece are, that stands against something at y = wall from x on."""
    return [
        Furniture(
            low=(x + it.low[0], wall - it.high[1], it.low[2]),
            high=(x + it.high[0], wall - it.low[1], it.high[2]),
            colour=it.colour,
            round=it.round,
        )
        for it in piece
    ]


def around(piece: Boxes) -> Furniture:
    """The box that holds a whole piece."""
    low = [min(it.low[k] for it in piece) for k in range(3)]
    high = [max(it.high[k] for it in piece) for k in range(3)]
    return Furniture(
        low=(low[0], low[1], low[2]), high=(high[0], high[1], high[2]), colour="#000000"
    )
