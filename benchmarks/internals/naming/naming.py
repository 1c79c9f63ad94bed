"""Do strangers name what the procedural library draws?

Measures internals, not the public API.

`python benchmarks/internals/naming/naming.py sheets FOLDER` draws one object of each category,
whichever the seed picks, in shuffled order and without a name; `--pool procedural-2` takes the
second edition's. Somebody who has seen no name writes a CSV (number, name).
`python benchmarks/internals/naming/naming.py score ANSWERS.csv ...` counts the answers that hold
the category or a synonym listed in `synonyms.yaml`, and prints the transcript as a table, wrong
answers in bold.
"""

from __future__ import annotations

import csv
import re
from collections.abc import Sequence
from pathlib import Path
from typing import Literal

import numpy as np
import tyro
import yaml
from rich.progress import track

from probe.api.resources import library
from probe.assets.library import Library, Pool
from probe.assets.spec import ObjectSpec
from probe.files import encode, write_bytes
from probe.report.contact_sheet import contact_sheet

A_SHEET = 12
SYNONYMS = Path(__file__).with_name("synonyms.yaml")


def chosen(things: Library, seed: int) -> list[ObjectSpec]:
    """One object of each category, shuffled."""
    rng = np.random.default_rng(seed)
    by_category: dict[str, list[ObjectSpec]] = {}
    for spec in things.specs:
        by_category.setdefault(spec.category, []).append(spec)
    picked = [some[int(rng.integers(len(some)))] for some in by_category.values()]
    return [picked[index] for index in rng.permutation(len(picked))]


def sheets(folder: Path, pool: Pool, seed: int) -> None:
    """Draw the sheets; `score` knows the key from the pool and the seed."""
    things = library(pool)
    specs = chosen(things, seed)
    for start in track(range(0, len(specs), A_SHEET), "Drawing"):
        some = specs[start : start + A_SHEET]
        sheet = contact_sheet(things, some, named=False, first=start + 1)
        write_bytes(folder / f"sheet_{start // A_SHEET + 1:02d}.png", encode(sheet, "PNG"))
    print(f"{len(specs)} objects are in {folder}")


def score(answers: Sequence[Path], pool: Pool, seed: int) -> None:
    """Print who said what, and how many were right."""
    synonyms: dict[str, list[str]] = yaml.safe_load(SYNONYMS.read_text("utf-8"))
    said = [read(path) for path in answers]
    right, specs = np.zeros(len(said), int), chosen(library(pool), seed)
    columns = "".join(f" said {number} |" for number in range(1, len(said) + 1))
    print(f"| | shown |{columns}\n|---|---|{'---|' * len(said)}")
    for number, spec in enumerate(specs, start=1):
        names = [spec.category, *synonyms.get(spec.category, [])]
        given = [answer.get(number, "") for answer in said]
        good = [any(holds(answer, name) for name in names) for answer in given]
        right += good
        cells = (word if ok else f"**{word}**" for word, ok in zip(given, good, strict=True))
        print(f"| {number} | {spec.name} ({spec.category}) | {' | '.join(cells)} |")
    print("\n" + ", ".join(f"{n} of {len(specs)} ({n / len(specs):.0%})" for n in right))


def read(answers: Path) -> dict[int, str]:
    """Names by number, of a CSV."""
    with answers.open(encoding="utf-8", newline="") as file:
        return {int(row[0]): row[1].strip() for row in csv.reader(file) if row and row[0].isdigit()}


def holds(answer: str, name: str) -> bool:
    """Whether an answer has a name in it, as whole words."""
    return re.search(rf"\b{re.escape(name)}\b", answer.lower()) is not None


def main(
    action: Literal["sheets", "score"],
    paths: tuple[Path, ...],
    pool: Pool = "procedural",
    seed: int = 0,
) -> None:
    """Draw sheets or score answers.

    Args:
        action: What to do.
        paths: A folder for the sheets, or files of answers.
        pool: Whose objects.
        seed: Which objects, in which order.
    """
    if action == "sheets":
        sheets(paths[0], pool, seed)
    else:
        score(paths, pool, seed)


if __name__ == "__main__":
    tyro.cli(main, config=(tyro.conf.PositionalRequiredArgs,))
