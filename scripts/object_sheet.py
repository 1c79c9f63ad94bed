"""Makes the README's sheet: `scripts/object_sheet.py SHEET.png docs/pictures/objects.jpg`.

SHEET.png is what `probe assets sheet --pool evaluation` writes. Numbers are left out, and a
last row that isn't full is centred.
"""

from __future__ import annotations

import math
import sys
from pathlib import Path

from PIL import Image

import probe
from probe.report.contact_sheet import CAPTION_PX, TILE_PX

WIDTH = 1620
WIDE = 1.25
"""Width of the picture divided by its height, about."""


def main(sheet: Path, out: Path) -> None:
    """Write the picture."""
    drawn = Image.open(sheet).convert("RGB")
    count = len({spec.category for spec in probe.open_library("evaluation").specs})
    across = drawn.width // TILE_PX
    columns = round(math.sqrt(WIDE * count))
    rows = math.ceil(count / columns)
    tiled = Image.new("RGB", (columns * TILE_PX, rows * TILE_PX), drawn.getpixel((0, TILE_PX // 2)))
    for number in range(count):
        left, top = number % across * TILE_PX, number // across * (TILE_PX + CAPTION_PX)
        tile = drawn.crop((left, top, left + TILE_PX, top + TILE_PX))
        row, column = divmod(number, columns)
        indent = (columns - min(columns, count - row * columns)) * TILE_PX // 2
        tiled.paste(tile, (indent + column * TILE_PX, row * TILE_PX))
    size = WIDTH, round(WIDTH * tiled.height / tiled.width)
    tiled.resize(size, Image.Resampling.LANCZOS).save(out, quality=84)
    print(f"{out}: {count} tiles, {columns} in a row")


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
