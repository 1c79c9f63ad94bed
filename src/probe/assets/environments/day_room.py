"""The rooms that new scenes stand in, drawn by number: a key light at one side, furniture ahead."""

from __future__ import annotations

import numpy as np

from probe.assets.environments.furnished import KINDS, around, furnished
from probe.assets.environments.pieces import CLOTHS, one_of
from probe.assets.environments.room import Room
from probe.assets.environments.shell import Shell, lights, on_walls

ROOM = "day_room"
"""Name of the light of new scenes: that of one of these rooms."""

COUNT = 48
"""How many there are."""

_EYE = 1.25
"""Height of a front camera above the floor: from there they are painted."""

_WALLS = ("#e6e4df", "#e2ddd2", "#d9dcdc", "#dfd8c8", "#c9cfc8", "#cdd3d8", "#d8c9b8", "#b9c0bc")
_FLOORS = ("#94897a", "#a07a52", "#7a5a3e", "#b9a184", "#8d8f8e", "#6a645e", "#c2bbb0")


def day_room_number(name: str) -> int | None:
    """Number of the room of this name, "day_room_7"; None for another name."""
    return next((n for n in range(COUNT) if name == f"{ROOM}_{n}"), None)


def day_room(number: int) -> Room:
    """A room.

    Args:
        number: From 0 below COUNT; even ones have their key light at the left.
    """
    rng = np.random.default_rng([4021, number])
    key = -1 if number % 2 == 0 else 1
    near, far = float(rng.uniform(1.05, 1.5)), float(rng.uniform(1.8, 3.2))
    shell = Shell(
        ahead=float(rng.uniform(3.2, 5.2)),
        behind=float(rng.uniform(1.4, 2.6)),
        left=near if key < 0 else far,
        right=far if key < 0 else near,
        height=float(rng.uniform(2.9, 3.4)),
    )
    pieces = furnished(shell, KINDS[number // 2 % len(KINDS)], rng)
    wall = one_of(rng, _WALLS)
    patterned = bool(rng.random() < 0.7)
    return Room(
        id=f"day_room_{number}",
        size=(shell.left + shell.right, shell.ahead + shell.behind, shell.height),
        eye=_EYE,
        stand=shell.stand,
        walls=(one_of(rng, _WALLS + CLOTHS[:2]) if rng.random() < 0.4 else wall, wall, wall, wall),
        floor=one_of(rng, _FLOORS),
        pattern=("planks", float(rng.uniform(0.1, 0.2))) if patterned else ("tiles", 0.5),
        patches=(*on_walls(shell, rng), *lights(shell, key, rng)),
        boxes=tuple(it for piece in pieces for it in piece),
        shading=tuple(around(piece) for piece in pieces),
    )
