"""The walls of a day room: windows, lamps, doors, and what hangs and lies there."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from probe.assets.environments.pieces import CLOTHS, WOODS, one_of
from probe.assets.environments.room import WallPatch

_DAYLIGHT = ("#faf7f2", "#f4f6fa", "#fdf4e4")
_LAMPLIGHT = ("#ffe6c4", "#fff0dc", "#ffdcae")


@dataclass(frozen=True)
class Shell:
    """An empty room: distances of its walls from where it is painted, metres."""

    ahead: float
    behind: float
    left: float
    right: float
    height: float

    @property
    def stand(self) -> tuple[float, float]:
        return (self.left - self.right) / 2, (self.behind - self.ahead) / 2


def lights(shell: Shell, key: int, rng: np.random.Generator) -> list[WallPatch]:
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


def on_walls(shell: Shell, rng: np.random.Generator) -> list[WallPatch]:
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
