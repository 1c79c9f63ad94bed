"""Divides the built-in objects between training and evaluation: src/probe/assets/data/pools.csv.

Builds every object (minutes), finds near-duplicates whatever their size, and gives each group to
one pool. An object that has a pool keeps it, and those of the first edition, which suites have
shown, are for evaluation; if near-duplicates would be parted by that, nothing is written.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

from probe.assets.mesh.likeness import like_pairs
from probe.assets.mesh.nearness import Fingerprint, NearPair, fingerprint
from probe.assets.pools.dividing import divide, in_parts
from probe.assets.pools.division import DIVISION, DividedObject, Part, divided, division_text
from probe.assets.pools.procedural import body_to_compare
from probe.assets.pools.split import groups_of
from probe.assets.procedural import specs
from probe.assets.procedural.tables import NEWEST_EDITION
from probe.cli.screen import say, track
from probe.files import write_text

FILE = Path(__file__).parents[1] / "src/probe/assets/data" / DIVISION


def division_of(
    ids: Sequence[str], alike: Iterable[NearPair], earlier: Mapping[str, Part]
) -> list[DividedObject]:
    """Every built-in object with its group and its pool.

    Args:
        ids: Of all of them.
        alike: Near-duplicates among them.
        earlier: The pools of those that have one.

    Raises:
        BadData: Near-duplicates would be parted.
    """
    shown: dict[str, Part] = {spec.id: "evaluation" for spec in specs(1)}
    groups = groups_of(ids, alike)
    return divide(groups, categories(), {**earlier, **shown})


def print_of(object_id: str) -> Fingerprint:
    """What tells near-duplicates of an object."""
    return fingerprint(body_to_compare(object_id).mesh)


def categories() -> dict[str, str]:
    """The category of each built-in object, by id."""
    return {spec.id: spec.category for spec in specs(NEWEST_EDITION)}


def main() -> None:
    """Write the file and say what is in it."""
    ids = list(categories())
    prints = {it: print_of(it) for it in track(ids, "Building", total=len(ids))}
    earlier: dict[str, Part] = {row.id: row.part for row in divided().values() if row.id in prints}
    rows = division_of(ids, like_pairs(prints), earlier)
    write_text(FILE, division_text(rows))
    parts = in_parts(rows, categories())
    for part, count in sorted(Counter(row.part for row in rows).items()):
        alone = sum(mine == frozenset((part,)) for mine in parts.values())
        say(f"{part}: {count} objects; {alone} categories are nowhere else.")
    say(f"{sum(len(mine) > 1 for mine in parts.values())} of {len(parts)} categories are in both.")
    say(f"{len(rows) - len({row.group for row in rows})} objects follow a near-duplicate.")


if __name__ == "__main__":
    main()
