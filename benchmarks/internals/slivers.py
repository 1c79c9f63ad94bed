"""Whether people can tell the partly hidden things that the ideal detector names, and those alone.

Measures internals, not the public API.

`python benchmarks/internals/slivers.py sheets FOLDER` makes fresh dense piles and draws things of
which 10 to 60 % show, outlined, as many that the detector names as not, shuffled and without a
name. Somebody who has seen no name writes a CSV: number, name or "can't tell". Then
`python benchmarks/internals/slivers.py score FOLDER ANSWERS.csv` counts whose category was said.
About 4 seconds a pile.
"""

from __future__ import annotations

import csv
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Literal

import numpy as np
import tyro
import yaml
from naming.naming import SYNONYMS, holds, read
from PIL import Image, ImageDraw
from rich.progress import track
from scipy.ndimage import binary_dilation
from scipy.stats import binomtest

from probe.api.resources import library, tables_for
from probe.assets.library import Library
from probe.errors import Unsatisfiable
from probe.files import encode, write_bytes
from probe.perception.naming import identifies
from probe.perception.oracle import NOTICED_PX
from probe.render.photograph import load_scene, measure, photograph
from probe.render.renderer import Renderer
from probe.scene.sampling import PileSettings
from probe.types import Array
from probe.world.scenes import make_scene

SHARES = 0.1, 0.6
TILE_PX, CAPTION_PX, AROUND_PX = 360, 24, 70
COLUMNS, ROWS = 4, 3
DENSE = PileSettings(reach=0.12, buried=4)


@dataclass(frozen=True, eq=False)
class Sliver:
    """A thing that shows in part, and its picture, sRGB uint8, shape (TILE_PX, TILE_PX, 3)."""

    category: str
    share: float
    named: bool
    tile: Array


def slivers(seed: int, things: Library, renderer: Renderer) -> Iterator[Sliver]:
    """The partly hidden things of a fresh pile, as the top camera shows them."""
    scene = make_scene(seed, things, tables_for("procedural"), pile=DENSE)
    load_scene(renderer, scene, things, things.table(scene.table))
    frame = photograph(renderer, scene)
    assert frame.rgb is not None and frame.labels is not None
    for number, seen in measure(renderer, scene).items():
        mask = frame.labels == number
        if SHARES[0] <= seen.fraction <= SHARES[1] and np.count_nonzero(mask) >= NOTICED_PX:
            spec = things[scene[number].object_id]
            named = identifies(mask, seen.fraction, spec.size)
            yield Sliver(spec.category, seen.fraction, named, tile(frame.rgb, mask))


def tile(rgb: Array, mask: Array) -> Array:
    """A square around a mask, outlined just outside of it."""
    rows, columns = np.nonzero(mask)
    half = int(max(np.ptp(rows), np.ptp(columns))) // 2 + AROUND_PX
    v, u = (int(axis.min() + axis.max()) // 2 for axis in (rows, columns))
    outlined = rgb.copy()
    outlined[binary_dilation(mask, iterations=4) & ~binary_dilation(mask, iterations=2)] = (
        255,
        0,
        255,
    )
    square = Image.fromarray(outlined).crop((u - half, v - half, u + half, v + half))
    return np.asarray(square.resize((TILE_PX, TILE_PX), Image.Resampling.LANCZOS))


def gather(first: int, each: int) -> list[Sliver]:
    """As many that are named as not, in the piles' order."""
    found: dict[bool, list[Sliver]] = {True: [], False: []}
    things = library("procedural")
    with Renderer(things.light_cache) as renderer:
        for seed in track(range(first, first + 20 * each), "Piles"):
            try:
                some = list(slivers(seed, things, renderer))
            except Unsatisfiable:
                continue
            for one in some:
                if len(found[one.named]) < each:
                    found[one.named].append(one)
            if all(len(kind) == each for kind in found.values()):
                break
    return found[True] + found[False]


def draw(folder: Path, first: int, each: int) -> None:
    """Write sheets of tiles, and the key into a folder of its own."""
    found = gather(first, each)
    order = np.random.default_rng(first).permutation(len(found))
    shuffled = [found[int(k)] for k in order]
    for start in range(0, len(shuffled), COLUMNS * ROWS):
        some = shuffled[start : start + COLUMNS * ROWS]
        path = folder / f"sheet_{start // (COLUMNS * ROWS) + 1:02d}.png"
        write_bytes(path, encode(sheet(some, start + 1), "PNG"))
    with (folder / "key.csv").open("w", encoding="utf-8", newline="") as file:
        rows = enumerate(shuffled, start=1)
        csv.writer(file).writerows((n, s.category, f"{s.share:.2f}", int(s.named)) for n, s in rows)
    print(f"{len(shuffled)} things are in {folder}; readers get the sheets without key.csv")


def sheet(some: Sequence[Sliver], first: int) -> Image.Image:
    """Tiles in rows, each above its number."""
    height = TILE_PX + CAPTION_PX
    page = Image.new("RGB", (COLUMNS * TILE_PX, ROWS * height), (255, 255, 255))
    pen = ImageDraw.Draw(page)
    for k, one in enumerate(some):
        x, y = k % COLUMNS * TILE_PX, k // COLUMNS * height
        page.paste(Image.fromarray(one.tile), (x, y))
        pen.text((x + 4, y + TILE_PX + 4), str(first + k), fill=(0, 0, 0), font_size=16)
    return page


def score(folder: Path, answers: Path) -> None:
    """Print how many of the named and of the others were told, and each answer."""
    synonyms: dict[str, list[str]] = yaml.safe_load(SYNONYMS.read_text("utf-8"))
    said, told = read(answers), dict[bool, list[bool]]({True: [], False: []})
    with (folder / "key.csv").open(encoding="utf-8", newline="") as file:
        for number, category, share, named in csv.reader(file):
            answer = said.get(int(number), "")
            right = any(holds(answer, name) for name in [category, *synonyms.get(category, [])])
            told[named == "1"].append(right)
            word = "named" if named == "1" else "not named"
            print(
                f"{number}\t{category}\t{share}\t{word}\t{'right' if right else 'WRONG'}\t{answer}"
            )
    for named, rights in told.items():
        low, high = binomtest(sum(rights), len(rights)).proportion_ci(method="wilson")
        of = f"{sum(rights)} of {len(rights)} ({low:.0%} to {high:.0%})"
        print(f"{'named' if named else 'not named'} by the detector: told by the reader {of}")


def main(
    action: Annotated[Literal["sheets", "score"], tyro.conf.Positional],
    folder: Annotated[Path, tyro.conf.Positional],
    answers: Annotated[Path | None, tyro.conf.Positional] = None,
    first: int = 970_000,
    each: int = 100,
) -> None:
    """Draw sheets or score answers.

    Args:
        action: What to do.
        folder: Of the sheets and the key.
        answers: A reader's CSV; for `score`.
        first: Seed of the first pile.
        each: Things that the detector names, and as many that it doesn't.
    """
    if action == "sheets":
        draw(folder, first, each)
    elif answers is None:
        raise SystemExit("score needs a reader's CSV: slivers.py score FOLDER ANSWERS.csv")
    else:
        score(folder, answers)


if __name__ == "__main__":
    tyro.cli(main)
