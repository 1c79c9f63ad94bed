"""What pieces of furniture are made of: boxes in a few colours, seen out of focus.

Each piece is drawn from a random source and stands along a wall. Its boxes have u along the wall
from the piece's left end, v away from the wall and z up, metres.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from probe.assets.environments.room import Furniture
from probe.types import Vector3

WOODS = ("#b48a5c", "#8a5f3c", "#5b3d28", "#d3b58a", "#c9a878", "#6f4a30")
PAINTED = ("#f0eeea", "#e6e2da", "#c9ced0", "#4a5258", "#7d8f86", "#2f3438", "#9aa7b2")
CLOTHS = ("#6d7a86", "#8c7a68", "#3f5a66", "#a5604a", "#6b7a58", "#b9ae9c", "#40465a", "#94474a")
LEAVES = ("#3c6b3a", "#4d7d44", "#2f5a3a", "#6a8f4e")
BRIGHT = ("#b5472f", "#d9a441", "#2f6f8f", "#e8e2d2", "#3d7a5a", "#7a3f5e", "#d07a3a", "#26303a")

Boxes = list[Furniture]
Make = Callable[[np.random.Generator], Boxes]


def box(low: Vector3, high: Vector3, colour: str, *, round: bool = False) -> Furniture:
    """A box of a piece."""
    return Furniture(low=low, high=high, colour=colour, round=round)


def one_of(rng: np.random.Generator, colours: Sequence[str]) -> str:
    """One of some colours, a little lighter or darker."""
    colour = colours[int(rng.integers(len(colours)))]
    by = float(rng.uniform(0.85, 1.1))
    parts = (min(255, round(int(colour[k : k + 2], 16) * by)) for k in (1, 3, 5))
    return "#" + "".join(f"{part:02x}" for part in parts)


def moved(boxes: Boxes, u: float, v: float) -> Boxes:
    """Boxes farther along the wall and away from it."""
    return [
        it.model_copy(
            update={
                "low": (it.low[0] + u, it.low[1] + v, it.low[2]),
                "high": (it.high[0] + u, it.high[1] + v, it.high[2]),
            }
        )
        for it in boxes
    ]


def things(rng: np.random.Generator, along: tuple[float, float], z: float, most: float) -> Boxes:
    """Books and other things side by side on a board."""
    made: Boxes = []
    u = along[0] + float(rng.uniform(0, 0.1))
    while u < along[1] - 0.08:
        wide = min(float(rng.uniform(0.03, 0.16)), along[1] - u)
        high = most * float(rng.uniform(0.45, 0.95))
        front = float(rng.uniform(0.2, 0.28))
        round_ = bool(rng.random() < 0.12)
        made.append(
            box(
                (u, 0.05, z),
                (u + wide, front, z + high),
                one_of(rng, BRIGHT + CLOTHS),
                round=round_,
            )
        )
        u += wide + (float(rng.uniform(0.05, 0.25)) if rng.random() < 0.25 else 0.004)
    return made
