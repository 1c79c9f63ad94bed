"""`probe assets split`: what is for training and what for evaluation, stored."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from probe.api.resources import Pool, library
from probe.assets.importers.parallel import spread
from probe.assets.library import Library
from probe.assets.mesh.nearness import Fingerprint, NearPair, fingerprint, near_pairs
from probe.assets.pools.split import EVALUATION_SHARE, Split, read_split, split_objects, write_split
from probe.cli.numbers import check_numbers
from probe.cli.screen import Column, ScreenTable, say, track
from probe.errors import WorkerDied

SHOWN = 20


def split(
    pool: Pool = "all",
    out: Path = Path("outputs/split.json"),
    share: float = EVALUATION_SHARE,
    workers: int = 2,
) -> None:
    """Split objects into a training and an evaluation part; near-duplicates stay together.

    If the file is there already, its objects stay where they are, and it is checked for
    near-duplicates on both sides.

    Args:
        pool: Which objects.
        out: File for the split.
        share: Of groups that go to evaluation, if the file is new.
        workers: Processes.
    """
    check_numbers({"--share": share, "--workers": workers})
    objects = library(pool)
    ids = [spec.id for spec in objects.specs]
    pairs = near_duplicates(objects, ids, workers)
    show_pairs(pairs)
    if out.exists():
        say(f"{out} is there: its objects stay where they are.")
    earlier = read_split(out) if out.exists() else Split(evaluation_share=share, parts={})
    made = split_objects(ids, pairs, earlier)
    write_split(out, made)
    counts = ", ".join(f"{len(made.ids(part))} {part}" for part in ("train", "evaluation"))
    say(f"{counts}; {len(pairs)} pairs of near-duplicates. The split is {out}")


def near_duplicates(objects: Library, ids: Sequence[str], workers: int) -> list[NearPair]:
    """Near-duplicates among objects of a library, nearest first."""
    jobs = [(objects, name) for name in ids]
    made = track(spread(_fingerprint, jobs, workers), "Comparing objects", total=len(jobs))
    found = {job[1]: seen for job, seen in made if seen is not None}
    if len(found) < len(jobs):
        raise WorkerDied("comparing objects")
    return near_pairs(found)


def show_pairs(pairs: Sequence[NearPair]) -> None:
    """Print the nearest pairs."""
    if not pairs:
        return
    table = ScreenTable(Column("near-duplicates", overflow="fold"), "", "fit", "texture")
    for pair in pairs[:SHOWN]:
        table.add(pair.one, pair.other, f"{pair.fit:.3f}", f"{pair.texture:.2f}")
    table.show()
    if len(pairs) > SHOWN:
        say(f"... and {len(pairs) - SHOWN} more pairs.")


def _fingerprint(job: tuple[Library, str]) -> Fingerprint:
    objects, object_id = job
    return fingerprint(objects.body(object_id).mesh)
