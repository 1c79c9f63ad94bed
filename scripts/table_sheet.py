"""Draws the sheet of painted tables: `scripts/table_sheet.py docs/pictures/tables.jpg`.

Each tile shows so much of a table's colours, seen from straight above. Painting takes about a
second a table.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import Annotated

import numpy as np
import tyro
from PIL import Image

from probe.assets.looks import NEWEST_LOOKS, Looks
from probe.assets.tables import TableMaterial, load_table
from probe.assets.tabletops import tops
from probe.files import encode, write_bytes
from probe.types import Array

SHOWN = 0.6
"""Metres of a table along an edge of its tile."""

TILE_PX, ACROSS = 84, 16


def tile(table: TableMaterial) -> Array:
    """A square of a table, uint8, shape (TILE_PX, TILE_PX, 3)."""
    repeats = math.ceil(SHOWN / table.tile_size)
    edge = round(len(table.texture) * SHOWN / table.tile_size)
    square = np.tile(table.texture, (repeats, repeats, 1))[:edge, :edge]
    small = Image.fromarray(square).resize((TILE_PX, TILE_PX), Image.Resampling.BOX)
    return np.asarray(small)


def sheet(looks: Looks) -> Array:
    """All tables in the order of their file, row by row, uint8, shape (h, w, 3)."""
    tiles = [tile(load_table(name, None, looks=looks)) for name in tops()]
    rows = math.ceil(len(tiles) / ACROSS)
    whole = np.full((rows * TILE_PX, ACROSS * TILE_PX, 3), 255, np.uint8)
    for number, one in enumerate(tiles):
        top, left = (TILE_PX * place for place in divmod(number, ACROSS))
        whole[top : top + TILE_PX, left : left + TILE_PX] = one
    return whole


def main(out: Annotated[Path, tyro.conf.Positional], *, looks: Looks = NEWEST_LOOKS) -> None:
    """Write the picture.

    Args:
        out: Its file, a JPEG.
        looks: How the tables look.
    """
    write_bytes(out, encode(Image.fromarray(sheet(looks)), "JPEG"))
    print(f"{out}: {len(tops())} tables in looks {looks}")


if __name__ == "__main__":
    tyro.cli(main)
