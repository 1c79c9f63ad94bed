"""A run killed at moments drawn by chance; what is there in the end must be the same."""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np
from command import PATIENCE, probe, surroundings
from verdict import Attack

from probe.episodes.files import line_of, read_records
from probe.episodes.folder import RECORDS

KIND = "kills"


def kills(
    folder: Path, suite: Path, agent: str, count: int, rng: np.random.Generator
) -> Iterator[Attack]:
    """Kill runs of a suite, go on with each to its end, compare with one that wasn't disturbed.

    Args:
        folder: For the runs.
        suite: A suite's file.
        agent: Who acts.
        count: How many runs are killed.
        rng: Draws the moments, evenly over the time that a run takes.
    """
    since = time.monotonic()
    undisturbed = probe("run", suite, "--agent", agent, "--out", folder / "undisturbed")
    taken = time.monotonic() - since
    if undisturbed.returncode != 0:
        yield Attack(KIND, "undisturbed", "crashed", undisturbed.stderr[-300:])
        return
    wanted = _timeless(folder / "undisturbed")
    for number in range(count):
        out, after = folder / str(number), float(rng.uniform(0.1, taken))
        words = ["run", str(suite), "--agent", agent, "--out", str(out)]
        process = subprocess.Popen(
            [sys.executable, "-m", "probe", *words],
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=surroundings({}),
        )  # fmt: skip
        try:
            process.wait(after)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait(PATIENCE)
        again = probe(*words)
        yield _judged(f"after {after:.1f} s", again, out, wanted)


def _judged(
    name: str, again: subprocess.CompletedProcess[str], out: Path, wanted: list[bytes]
) -> Attack:
    if again.returncode != 0:
        return Attack(KIND, name, "crashed", again.stderr[-300:])
    same = _timeless(out) == wanted
    return Attack(KIND, name, "harmless" if same else "read wrongly", "other records" * (not same))


def _timeless(out: Path) -> list[bytes]:
    return sorted(line_of(record, timed=False) for record in read_records(out / RECORDS))
