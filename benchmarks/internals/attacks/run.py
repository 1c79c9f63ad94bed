"""Everything that an attacker tried, again: `python benchmarks/internals/attacks/run.py --help`.

Measures internals, not the public API.

Spoilt files and options, forged records, flipped bits, requests to both ports, kills, strange
replies of a model. Each is refused in one clear line or does no harm; what crashed or was read
wrongly is printed, and the exit status says so. Takes about half an hour on two cores.
"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Callable, Iterator, Mapping
from pathlib import Path

import numpy as np
import tyro
from command import probe
from files import attack_files, attack_memory, attack_options
from flips import flips
from forged_records import attack_records
from kills import kills
from meshes import attack_meshes
from ports import attack_line, attack_page
from rich.console import Console
from strange_replies import attack_with_replies
from verdict import Attack, show

from probe.episodes.files import read_records
from probe.episodes.folder import RECORDS
from probe.tasks.suite import selection
from probe.tasks.suite_file import demo_suite, read_suite, write_suite

_RECORD_FLIPS, _SUITE_FLIPS, _KILLS = 200, 800, 28


def prepared(folder: Path) -> Path:
    """A folder as `probe run` leaves it: one episode of the demo, by a hand that errs.

    Its one task lies beside it as a suite of no packaged name.
    """
    whole = demo_suite()
    write_suite(folder / "one.json", selection(whole, whole.tasks[:1], "one"))
    write_suite(folder / "demo.json", selection(whole, whole.tasks[:1], whole.name))
    out = folder / "run"
    ended = probe("run", folder / "demo.json", "--noise", "paper", "--out", out)
    if ended.returncode != 0:
        sys.exit(ended.stderr)
    return out


def attacks_of(folder: Path, scale: float) -> Mapping[str, Callable[[], Iterator[Attack]]]:
    """All attacks, by the name under which they can be asked for.

    Args:
        folder: To work in.
        scale: The share of each that is tried; of page and line, all.
    """
    rng = np.random.default_rng(0)
    run, suite = prepared(folder), folder / "one.json"

    def flipped() -> Iterator[Attack]:
        of_records, of_suite = round(scale * _RECORD_FLIPS), round(scale * _SUITE_FLIPS)
        yield from flips("flips in records", run / RECORDS, read_records, of_records, rng)
        yield from flips("flips in a suite", suite, read_suite, of_suite, rng)

    count = round(scale * _KILLS)
    return {
        "files": lambda: attack_files(folder, run, scale),
        "meshes": lambda: attack_meshes(folder, scale),
        "options": lambda: attack_options(folder, scale),
        "memory": lambda: attack_memory(folder, scale),
        "records": lambda: attack_records(folder, run, scale),
        "flips": flipped,
        "page": lambda: attack_page(folder / "page"),
        "line": lambda: attack_line(folder / "line"),
        "kills": lambda: kills(folder / "kills", suite, "scripted", count, rng),
        "replies": lambda: attack_with_replies(folder / "replies", scale),
    }


def main(only: tuple[str, ...] = (), scale: float = 1.0) -> None:
    """Try everything, and print the table.

    Args:
        only: Some of these names, by default all: files, meshes, options, memory, records, flips,
            page, line, kills, replies.
        scale: The share of each that is tried; of page and line, all.
    """
    console, tried = Console(), list[Attack]()
    with tempfile.TemporaryDirectory() as folder:
        known = attacks_of(Path(folder), scale)
        if unknown := set(only) - set(known):
            sys.exit(f"There is nothing called {', '.join(unknown)}. Known: {', '.join(known)}.")
        for name in only or known:
            console.print(f"{name} ...")
            tried += known[name]()
    if through := show(tried, console):
        sys.exit(f"{through} of {len(tried)} attacks crashed something or were read wrongly.")


if __name__ == "__main__":
    tyro.cli(main)
