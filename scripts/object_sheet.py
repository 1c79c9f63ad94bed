"""Makes the README's sheet: `scripts/object_sheet.py SHEET.png docs/pictures/objects.jpg`.

SHEET.png is what `probe assets sheet` writes. Numbers are left out, and rows are as even as can be.
"""

from __future__ import annotations

import sys
from pathlib import Path

from PIL import Image

import probe
from probe.report.contact_sheet import CAPTION_PX, TILE_PX

WIDTH = 1620
WIDEST = 24
"""Tiles in a row, at most."""


def main(sheet: Path, out: Path) -> None:
    """Write the picture."""
    drawn = Image.open(sheet).convert("RGB")
    count = len({spec.category for spec in probe.open_library().specs})
    across = drawn.width // TILE_PX
    columns = max(n for n in range(1, WIDEST) if count % n == 0)
    tiled = Image.new("RGB", (columns * TILE_PX, count // columns * TILE_PX))
    for number in range(count):
        left, top = number % across * TILE_PX, number // across * (TILE_PX + CAPTION_PX)
        tile = drawn.crop((left, top, left + TILE_PX, top + TILE_PX))
        tiled.paste(tile, (number % columns * TILE_PX, number // columns * TILE_PX))
    size = WIDTH, round(WIDTH * tiled.height / tiled.width)
    tiled.resize(size, Image.Resampling.LANCZOS).save(out, quality=84)
    print(f"{out}: {count} tiles, {columns} in a row")


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
