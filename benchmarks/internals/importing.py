"""The 165 scans in other people's layouts: let in, named, coloured, weighed and set upright?

Measures internals, not the public API.

About 5 s an object on an idle core, nearly all of it for collision pieces.

`python benchmarks/internals/importing.py [--shard 0 --shards 4]`; needs PROBE_ASSETS. Every scan is
written anew in one of nine public layouts, with the quirks they have, below a temporary folder, and
added to a library there as `probe assets add` adds it. What comes out is held against the
catalogue, which was annotated by eye.
"""

from __future__ import annotations

import tempfile
import time
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import tyro
from importing_layouts import LAYOUTS, Layout, original_names, read_scan

from probe.api.resources import assets_folder
from probe.assets.gltf.glb import measure_glb
from probe.assets.importers.adding import ImportOutcome, ImportTarget, add, objects_at
from probe.assets.importers.options import ImportOptions
from probe.assets.importers.source import Format
from probe.assets.library import scans_folder
from probe.assets.pools.entry import LibraryEntry
from probe.assets.pools.own import own_entries
from probe.assets.pools.scan_catalogue import ScanRow, scan_rows

SAID: dict[str, set[str]] = {
    "silver": {"gray"},
    "tan": {"beige", "brown"},
    "gold": {"yellow", "brown"},
    "light gray": {"gray", "white"},
    "dark gray": {"gray", "black"},
    "light brown": {"brown", "beige"},
}
"""Which of our thirteen colour words are right for an annotated one of several words."""


@dataclass(frozen=True)
class Added:
    """A scan, how it was laid out, and what the library says of it; no entry if it was refused."""

    row: ScanRow
    layout: str
    original: str
    outcome: ImportOutcome | None
    entry: LibraryEntry | None


def main(shard: int = 0, shards: int = 1, workers: int = 1, show: bool = False) -> None:
    """Print the counts.

    Args:
        shard: Which part of the scans.
        shards: Into how many parts they are split.
        workers: Processes.
        show: Also print each object.
    """
    folder = scans_folder(assets_folder())
    names = original_names(folder)
    rows = [row for number, row in enumerate(scan_rows()) if number % shards == shard]
    found: list[Added] = []
    passed: Counter[str] = Counter()
    start = time.perf_counter()
    for number, (title, layout) in enumerate(LAYOUTS.items()):
        mine = [row for at, row in enumerate(rows) if at % len(LAYOUTS) == number]
        if not mine:
            continue
        with tempfile.TemporaryDirectory() as home:
            for at, row in enumerate(mine):
                scan = read_scan(folder, row.id, names[row.id], 100 + at, row.mass)
                layout.write(Path(home) / "objects", scan)
            found += _added(Path(home), mine, names, title, layout, workers, passed)
    _print(found, passed, time.perf_counter() - start, show)


def _added(
    home: Path,
    rows: Sequence[ScanRow],
    names: dict[str, str],
    title: str,
    layout: Layout,
    workers: int,
    passed: Counter[str],
) -> list[Added]:
    """Add a folder of one layout, and find each scan again by its place."""
    format: Format = layout.format  # pyright: ignore[reportAssignmentType]
    order = ImportOptions(format, licence="CC-BY-4.0")
    sources, over = objects_at(home / "objects", order)
    passed.update(one.reason.partition(" as ")[0] for one in over)
    target = ImportTarget(home / "library", home / "cache")
    outcomes = list(add(sources, order, target, workers))
    entries = {entry.id: entry for entry in own_entries(target.library)}
    found: list[Added] = []
    for row in rows:
        name = names[row.id]
        mine = [one for one in outcomes if _is_of(one.label, name)]
        assert len(mine) <= 1, (name, mine)
        outcome = mine[0] if mine else None
        entry = entries.get(outcome.detail) if outcome else None
        found.append(Added(row, title, name, outcome, entry))
    return found


def _is_of(label: str, name: str) -> bool:
    parts = {Path(part).stem for part in Path(label).parts}
    return any(part == name or part.partition("_")[2] == name for part in parts)


def _print(found: Sequence[Added], passed: Counter[str], seconds: float, show: bool) -> None:
    done = [(one, one.entry) for one in found if one.entry is not None]
    count = len(found)
    print(f"let in {len(done)} of {count}; {seconds / max(1, count):.1f} s an object")
    for one in found:
        if one.entry is None:
            why = one.outcome.detail if one.outcome else "not found"
            print(f"  refused ({one.layout}) {one.row.id}: {why.split('/')[-1]}")
        elif show:
            said = (one.entry.name, one.entry.category, one.entry.colours, one.entry.mass)
            print(f"  {one.layout:10} {one.row.id} -> {one.entry.id} {said}")
    print(f"passed over: {dict(passed)}")
    named = [one for one, entry in done if _words(one.row.category)[-1] in _text(entry)]
    possible = [one for one, _ in done if _words(one.row.category)[-1] in _plain(one.original)]
    print(
        f"category's noun in the name: {len(named)} (the sources' names have it: {len(possible)})"
    )
    some = [one for one, entry in done if set(_nouns(one.row)) & set(_text(entry).split())]
    print(f"some noun of the annotated name or category in it: {len(some)}")
    silent = [entry.id for _, entry in done if entry.name in ("textured", "model", "object")]
    print(f"named after nothing: {len(silent)}")
    first = sum(entry.colours[0] in _said(one.row.colours[0]) for one, entry in done)
    among = sum(any(entry.colours[0] in _said(it) for it in one.row.colours) for one, entry in done)
    print(f"first colour is the annotated first: {first}; is among the annotated: {among}")
    for title, stated in (("stated", True), ("guessed", False)):
        ratios = np.array(
            [e.mass / o.row.mass for o, e in done if LAYOUTS[o.layout].states_mass is stated]
        )
        within = ", ".join(
            f"within {k}: {int(((ratios >= 1 / k) & (ratios <= k)).sum())}" for k in (2, 3)
        )
        low, high = (ratios.min(), ratios.max()) if len(ratios) else (np.nan, np.nan)
        print(f"mass {title}, n {len(ratios)}: {low:.2f} to {high:.2f} times; {within}")
    sure = [(one, entry) for one, entry in done if entry.up_sure]
    other = [one.row.id for one, entry in sure if not _stands(one, entry)]
    print(
        f"upward axis: sure of {len(sure)}; of these not as annotated: {', '.join(other) or 'none'}"
    )
    remarks = Counter(text.split(":")[0].split(" (")[0] for _, e in done for text in e.remarks)
    print(f"remarks: {dict(remarks)}")


def _stands(one: Added, entry: LibraryEntry) -> bool:
    """Whether it lies as annotated by eye: the same height, give or take an eighth."""
    folder = scans_folder(assets_folder())
    height = measure_glb(folder / f"{one.row.id}.glb", one.row.up)[2]
    return abs(entry.size[2] - height) < max(0.125 * height, 0.004)


def _said(word: str) -> set[str]:
    return SAID.get(word) or {word.split()[-1]}


def _text(entry: LibraryEntry) -> str:
    return f"{entry.name} {entry.category}"


def _plain(name: str) -> str:
    return name.lower().replace("_", " ")


def _words(text: str) -> list[str]:
    return [word.removesuffix("s") for word in text.split()]


def _nouns(row: ScanRow) -> list[str]:
    colours = {word for colour in row.colours for word in colour.split()}
    every = _words(f"{row.name} {row.category}".replace("-", " "))
    return [it for word in every for it in (word, f"{word}s") if word not in colours]


if __name__ == "__main__":
    tyro.cli(main)
