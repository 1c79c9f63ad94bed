"""What a painter of table tops hands back."""

from __future__ import annotations

from dataclasses import dataclass

from probe.types import Array


@dataclass(frozen=True, eq=False)
class Sheet:
    """One repeat of a table top.

    Attributes:
        colour: sRGB, 0 to 255, float, shape (SIZE, SIZE, 3).
        height: Relief in metres, shape (SIZE, SIZE).
        tile_size: Metres along an edge of the repeat.
        roughness: 0 (mirror) to 1 (chalk).
    """

    colour: Array
    height: Array
    tile_size: float
    roughness: float
