"""Near-duplicates among the objects that appear somewhere, kept once they are known."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from pathlib import Path

from probe.assets.cache import content_key
from probe.assets.library import Library
from probe.assets.mesh.fingerprint import Fingerprint
from probe.assets.pools.split import groups_of
from probe.cli.assets_split import near_duplicates
from probe.cli.screen import say
from probe.errors import BadData
from probe.files import write_text
from probe.tasks.suite import Suite


def near_groups(
    shown: Sequence[Mapping[str, Fingerprint]], things: Library, kept: Path, workers: int
) -> list[list[str]]:
    """Groups of near-duplicates among objects, from a file if they are known.

    Args:
        shown: Fingerprints of the objects that appear, by id: of each suite or collection.
        things: All objects.
        kept: Folder for what is known.
        workers: Processes.

    Raises:
        BadData: An object that appears isn't there, so that nobody can tell what it is like.
        OutputFailed: What was found can't be kept.
    """
    # A user's own object may change and keep its id.
    looks = sorted({f"{id} {mark}" for marks in shown for id, mark in marks.items()})
    path = kept / f"{content_key('near-duplicates 2', *looks)}.json"
    if path.exists():
        return json.loads(path.read_text())
    ids = sorted({id for marks in shown for id in marks})
    _check_there(ids, things)
    pairs = near_duplicates(things, ids, workers)
    groups = [group for group in groups_of(ids, pairs) if len(group) > 1]
    write_text(path, json.dumps(groups))
    return groups


def those_here(suites: Sequence[Suite], things: Library) -> list[Suite]:
    """Suites whose objects are here to be compared; of the others it says that they aren't."""
    missing = {suite.name: _missing(sorted(suite.objects), things) for suite in suites}
    for name, ids in missing.items():
        if ids:
            say(f"{len(ids)} objects of {name} aren't here (PROBE_ASSETS): kept out by id alone.")
    return [suite for suite in suites if not missing[suite.name]]


def _check_there(ids: Sequence[str], things: Library) -> None:
    missing = _missing(ids, things)
    if missing:
        others = f" (and {len(missing) - 1} more)" if len(missing) > 1 else ""
        reason = f"appears{others}, but isn't here to be compared with other objects"
        remedy = "Set PROBE_ASSETS (scans) or PROBE_LIBRARY (your own) to the folder that holds it"
        raise BadData(missing[0], reason, f"{remedy}, or compare ids alone with --no-near")


def _missing(ids: Sequence[str], things: Library) -> list[str]:
    known = {spec.id for spec in things.specs}
    return [id for id in ids if id not in known]
