"""What a painter of table tops is told, and what it hands back."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated

import numpy as np
from pydantic import BaseModel, ConfigDict, Field

from probe.types import Array

Colour = Annotated[str, Field(pattern=r"^#[0-9a-f]{6}$")]


@dataclass(frozen=True, eq=False)
class TableTile:
    """One repeat of a table top.

    Attributes:
        colour: sRGB, 0 to 255, float, shape (SIZE, SIZE, 3).
        height: Relief in metres, shape (SIZE, SIZE).
        tile_size: Metres along an edge of the repeat.
        roughness: 0 (mirror) to 1 (chalk).
        metallic: 0, or 1 for bare metal.
        roughness_map: Roughness where it differs from place to place, shape (SIZE, SIZE), or None.
    """

    colour: Array
    height: Array
    tile_size: float
    roughness: float
    metallic: float = 0.0
    roughness_map: Array | None = None


class Top(BaseModel):
    """A table top as data; each kind has its own looks.

    Attributes:
        tile_size: Metres along an edge of the repeat.
    """

    model_config = ConfigDict(frozen=True, extra="forbid")

    id: str = Field(pattern=r"^[a-z0-9_]+$")
    tile_size: float = Field(gt=0.05, le=2)
    roughness: float = Field(ge=0, le=1)

    @abstractmethod
    def paint(self, rng: np.random.Generator) -> TableTile:
        """Draw one repeat."""


def rgb(colour: str) -> Array:
    """SRGB, 0 to 255, shape (3,), of "#rrggbb"."""
    return np.array([int(colour[k : k + 2], 16) for k in (1, 3, 5)])


def palette(colours: Sequence[str]) -> Array:
    """SRGB, 0 to 255, shape (n, 3)."""
    return np.array([rgb(colour) for colour in colours])
