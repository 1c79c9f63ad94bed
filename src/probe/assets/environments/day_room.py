"""The rooms that new scenes stand in, drawn by number: a key light at one side, furniture ahead."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from probe.assets.environments.pieces import CLOTHS, WOODS, Boxes, Make, moved, one_of
from probe.assets.environments.room import Furniture, Room, WallPatch
from probe.assets.environments.seats import chair, desk, plant, radiator, sofa
from probe.assets.environments.storage import counter, cupboard, shelf, stack

ROOM = "day_room"
"""Name of the light of new scenes: that of one of these rooms."""

COUNT = 48
"""How many there are."""

_EYE = 1.25
"""Height of a front camera above the floor: from there they are painted."""

_BEYOND_TABLE = 1.85
"""Metres ahead of it where the table has ended."""

_WALLS = ("#e6e4df", "#e2ddd2", "#d9dcdc", "#dfd8c8", "#c9cfc8", "#cdd3d8", "#d8c9b8", "#b9c0bc")
_FLOORS = ("#94897a", "#a07a52", "#7a5a3e", "#b9a184", "#8d8f8e", "#6a645e", "#c2bbb0")
_DAYLIGHT = ("#faf7f2", "#f4f6fa", "#fdf4e4")
_LAMPLIGHT = ("#ffe6c4", "#fff0dc", "#ffdcae")
_KINDS: tuple[tuple[Make, ...], ...] = (
    (shelf, cupboard, sofa, plant, radiator),
    (counter, cupboard, plant, radiator, shelf),
    (desk, shelf, cupboard, plant, stack),
    (stack, shelf, desk, counter, radiator),
    (sofa, shelf, cupboard, plant, radiator),
)
"""What stands in each kind of room; the first is there in any case."""


@dataclass(frozen=True)
class _Shell:
    """An empty room: distances of its walls from where it is painted, metres."""

    ahead: float
    behind: float
    left: float
    right: float
    height: float

    @property
    def stand(self) -> tuple[float, float]:
        return (self.left - self.right) / 2, (self.behind - self.ahead) / 2


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
    shell = _Shell(
        ahead=float(rng.uniform(2.6, 5.0)),
        behind=float(rng.uniform(1.4, 2.6)),
        left=near if key < 0 else far,
        right=far if key < 0 else near,
        height=float(rng.uniform(2.9, 3.4)),
    )
    pieces = _furnished(shell, _KINDS[number // 2 % len(_KINDS)], rng)
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
        patches=(*_on_walls(shell, rng), *_lights(shell, key, rng)),
        boxes=tuple(it for piece in pieces for it in piece),
        shading=tuple(_around(piece) for piece in pieces),
    )


def _lights(shell: _Shell, key: int, rng: np.random.Generator) -> list[WallPatch]:
    """The key light, a window at one side or a lamp above; and a window behind that fills."""
    across = -shell.stand[0]
    back = WallPatch(
        side="back",
        at=(float(rng.uniform(-0.8, 0.8)) + across, 1.9),
        size=(1.0, 1.2),
        colour=one_of(rng, _DAYLIGHT),
        glow=float(rng.uniform(2.0, 3.5)),
        frame=0.06,
    )
    if rng.random() < 0.25:
        place = (
            shell.stand[0] + key * float(rng.uniform(0.9, 1.25)),
            shell.stand[1] + float(rng.uniform(-0.4, 0.9)),
        )
        colour = _LAMPLIGHT[int(rng.integers(len(_LAMPLIGHT)))]
        return [
            WallPatch(side="ceiling", at=place, size=(0.55, 0.55), colour=colour, glow=90),
            back,
        ]
    reach = shell.left if key < 0 else shell.right
    forward = reach / math.tan(math.radians(float(rng.uniform(58, 130))))
    along = (shell.stand[1] + forward) * (1 if key < 0 else -1)
    colour = _DAYLIGHT[int(rng.integers(len(_DAYLIGHT)))]
    window = WallPatch(
        side="left" if key < 0 else "right",
        at=(along, shell.height - float(rng.uniform(0.55, 0.75))),
        size=(float(rng.uniform(0.9, 1.2)), float(rng.uniform(0.85, 1.05))),
        colour=colour,
        glow=60 * (reach / 1.5) ** 2,
        frame=0.07,
        panes=(2, 1),
    )
    return [window, back]


def _on_walls(shell: _Shell, rng: np.random.Generator) -> list[WallPatch]:
    """What the wall ahead and the floor have on them."""
    middle, wide = shell.stand[0], shell.left + shell.right
    board = one_of(rng, ("#f2f0ec", "#efece6", WOODS[1]))
    made = [WallPatch(side="front", at=(0.0, 0.05), size=(wide, 0.1), colour=board)]
    if rng.random() < 0.6:
        place = (
            middle + float(rng.uniform(-0.6, 0.6)),
            shell.stand[1] + float(rng.uniform(2.6, 3.4)),
        )
        size = (float(rng.uniform(1.4, 2.4)), float(rng.uniform(1.2, 1.8)))
        made.append(WallPatch(side="floor", at=place, size=size, colour=one_of(rng, CLOTHS)))
    if rng.random() < 0.45:
        made += _garden_door(middle + float(rng.uniform(-0.9, 0.9)), rng)
    elif rng.random() < 0.5:
        place = (middle + float(rng.uniform(-1.2, 1.2)), 1.03)
        door = one_of(rng, ("#f0eeea", *WOODS))
        made.append(WallPatch(side="front", at=place, size=(0.85, 2.06), colour=door, frame=0.08))
    if rng.random() < 0.4:
        place = (middle + float(rng.uniform(-1, 1)), float(rng.uniform(0.4, 0.8)))
        size = (float(rng.uniform(0.3, 0.7)), float(rng.uniform(0.4, 0.9)))
        made.append(WallPatch(side="front", at=place, size=size, colour="#ffe9c8", glow=1.2))
    for _ in range(int(rng.integers(1, 6)) if rng.random() < 0.35 else 0):
        place = (middle + float(rng.uniform(-1.4, 1.4)), float(rng.uniform(0.5, 1.1)))
        colour = one_of(rng, _LAMPLIGHT)
        made.append(WallPatch(side="front", at=place, size=(0.035, 0.035), colour=colour, glow=14))
    return made


def _garden_door(across: float, rng: np.random.Generator) -> list[WallPatch]:
    """A door of glass: sky, and green below."""
    wide = float(rng.uniform(0.8, 1.5))
    green = one_of(rng, ("#8fae78", "#a9b98c", "#b9bdb4"))
    return [
        WallPatch(
            side="front",
            at=(across, 1.3),
            size=(wide, 1.7),
            colour="#eef4fb",
            glow=3.2,
            frame=0.08,
            panes=(2, 1),
        ),
        WallPatch(
            side="front", at=(across, 0.65), size=(wide, 0.5), colour=green, glow=2.0, panes=(2, 1)
        ),
    ]


def _furnished(shell: _Shell, kind: tuple[Make, ...], rng: np.random.Generator) -> list[Boxes]:
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


def _around(piece: Boxes) -> Furniture:
    """The box that holds a whole piece."""
    low = [min(it.low[k] for it in piece) for k in range(3)]
    high = [max(it.high[k] for it in piece) for k in range(3)]
    return Furniture(
        low=(low[0], low[1], low[2]), high=(high[0], high[1], high[2]), colour="#000000"
    )
