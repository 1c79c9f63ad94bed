"""`probe assets add` and `probe assets check`: other people's objects, let in or turned away."""

from __future__ import annotations

import statistics
from collections import Counter
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Annotated, Literal

import tyro

from probe.api.resources import assets_folder, cache_folder, library, library_folder
from probe.assets.importers.adding import ImportOutcome, ImportTarget, add, objects_at
from probe.assets.importers.checking import (
    Candidate,
    FitnessVerdict,
    check,
    own_candidates,
    scan_candidates,
    sifted_at,
)
from probe.assets.importers.options import ImportOptions
from probe.assets.importers.selection import Passed
from probe.assets.importers.source import Axis, Format
from probe.assets.library import own_folder, scans_folder
from probe.cli.assets_split import near_duplicates, show_pairs
from probe.cli.numbers import check_numbers
from probe.cli.screen import Column, ScreenTable, say, track
from probe.errors import BadData, ObjectsRefused

Unit = Literal["m", "cm", "mm"]
_METRES: dict[Unit, float] = {"m": 1.0, "cm": 0.01, "mm": 0.001}
_SHOWN = 3


def add_objects(
    format: Annotated[Format, tyro.conf.Positional],
    path: Annotated[Path, tyro.conf.Positional],
    unit: Unit | None = None,
    up: Axis | None = None,
    licence: str | None = None,
    source: str | None = None,
    workers: int = 2,
) -> None:
    """Add objects to your library: upright, lying as they come to rest, with licence and source.

    May be interrupted: what is there already is skipped the next time.

    Args:
        format: gltf (GLB too), obj, gso (Google Scanned Objects) or bop (BOP models).
        path: A folder of objects, or one file.
        unit: m, cm or mm; if left out, the format's own (obj: m).
        up: The files' upward axis; if left out, the format's own, or for obj what the shape says.
        licence: SPDX identifier, for objects whose files state no licence.
        source: Who made them, for objects whose files don't say.
        workers: Processes.
    """
    check_numbers({"--workers": workers})
    order = ImportOptions(format, _METRES[unit] if unit else None, up, licence, source)
    sources, passed = objects_at(path, order)
    _tell_passed(passed)
    target = ImportTarget(library_folder(), cache_folder())
    running = add(sources, order, target, workers)
    outcomes = list(track(running, "Adding objects", total=len(sources)))
    _tell(outcomes, target.library)
    fresh = {outcome.detail for outcome in outcomes if outcome.status == "added"}
    if fresh:
        _tell_near(fresh, workers)
        say("`probe assets review outputs/review` shows them, beside a table to correct.")


def check_objects(
    what: Annotated[str, tyro.conf.Positional] = "own",
    unit: Unit | None = None,
    up: Axis | None = None,
    workers: int = 1,
) -> None:
    """Check whether each object can be used, and if not why; nothing is written.

    The exit status is 1 if one can't.

    Args:
        what: scans or own (pools), or a folder or file of objects.
        unit: m, cm or mm; if left out, each format's own.
        up: The files' upward axis; if left out, each format's own, or for obj what the shape says.
        workers: Processes; with 1, the time of collision pieces is that of one core.
    """
    check_numbers({"--workers": workers})
    candidates, passed = _candidates(what, unit, up)
    verdicts = list(track(check(candidates, workers), "Checking", total=len(candidates)))
    _tell_passed(passed)
    table = ScreenTable(Column("object", overflow="fold"), "verdict", "remarks", "pieces", "s")
    for verdict in sorted(verdicts, key=lambda verdict: verdict.label):
        cost = (str(verdict.pieces), f"{verdict.seconds:.1f}") if verdict.pieces else ("", "")
        table.add(verdict.label, verdict.refusal or "OK", "; ".join(verdict.remarks), *cost)
    table.show()
    _sum_up(verdicts)
    if refused := sum(verdict.refusal is not None for verdict in verdicts):
        raise ObjectsRefused(refused, len(verdicts))


def _candidates(
    what: str, unit: Unit | None, up: Axis | None
) -> tuple[list[Candidate], list[Passed]]:
    if what not in ("scans", "own"):
        return sifted_at(Path(what), _METRES[unit] if unit else None, up)
    if unit or up:
        remedy = "Leave them out, or name a folder or file of objects."
        raise BadData(what, "--unit and --up are about files", remedy)
    if what == "scans":
        return scan_candidates(scans_folder(assets_folder())), []
    return own_candidates(own_folder(library_folder())), []


def _tell_passed(passed: Sequence[Passed]) -> None:
    """Say which meshes are no objects of their own; many of one reason, once with their number."""
    counts = Counter(one.reason.partition(" as ")[0] for one in passed)
    for reason, count in counts.most_common():
        these = [one for one in passed if one.reason.startswith(reason)]
        shown = "; ".join(
            one.label + one.reason.removeprefix(reason).replace(" as ", " -> ")
            for one in these[:_SHOWN]
        )
        more = "; ..." if count > _SHOWN else ""
        say(f"{count} meshes are passed over, {reason}: {shown}{more}")


def _sum_up(verdicts: Iterable[FitnessVerdict]) -> None:
    known = list(verdicts)
    refused = sum(verdict.refusal is not None for verdict in known)
    say(f"{len(known)} objects: {len(known) - refused} OK, {refused} refused.")
    times = [verdict.seconds for verdict in known if verdict.pieces]
    if times:
        middle, most = statistics.median(times), max(times)
        say(f"Collision pieces: median {middle:.1f} s, at most {most:.1f} s of CPU an object.")


def _tell_near(fresh: set[str], workers: int) -> None:
    """Say which of the new objects look like one that was there, or like each other."""
    objects = library("own")
    pairs = near_duplicates(objects, [spec.id for spec in objects.specs], workers)
    show_pairs([pair for pair in pairs if fresh & {pair.one, pair.other}])


def _tell(outcomes: list[ImportOutcome], library: Path) -> None:
    reason = Column("id, or reason", overflow="fold")
    table = ScreenTable(
        Column("object", overflow="fold"), "", reason, Column("remarks", overflow="fold")
    )
    for outcome in sorted(outcomes, key=lambda outcome: (outcome.status, outcome.label)):
        table.add(outcome.label, outcome.status, outcome.detail, "; ".join(outcome.remarks))
    table.show()
    counts = Counter(outcome.status for outcome in outcomes)
    told = ", ".join(f"{counts[status]} {status}" for status in ("added", "skipped", "refused"))
    say(f"{told}. Your library is {library}")
