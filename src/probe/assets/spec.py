"""What the catalogue says of an object; words and numbers, no geometry."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Origin = Literal["scan", "procedural", "own"]


@dataclass(frozen=True)
class ObjectSpec:
    """One object of the library.

    Attributes:
        id: Unique and stable, lower case with underscores ("ycb_025_mug").
        name: Short name, unique in the catalogue unless two objects look alike ("red mug").
        category: Common noun ("mug").
        colours: Main colours by share of the surface, largest first ("red", "black").
        description: One sentence of what one sees, without the name of a brand it can't show.
        mass: Kilograms.
        friction: Sliding friction coefficient.
        size: Extent along x, y, z in metres in the resting pose.
        hollow: True if it has a cavity that could hold or cover something.
        origin: Where its geometry comes from.
        licence: SPDX identifier.
        source: Who made it, or which data set.
    """

    id: str
    name: str
    category: str
    colours: tuple[str, ...]
    description: str
    mass: float
    friction: float
    size: tuple[float, float, float]
    hollow: bool
    origin: Origin
    licence: str
    source: str
