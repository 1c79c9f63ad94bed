"""Divides objects between training and evaluation: groups stay whole, categories are in both.

Who has a place keeps it, and a group goes where one of its objects is. In a category that is for
evaluation already, all other groups are for training; in any other a share of the groups is for
evaluation, at least one where there are two. A hash of their names decides which. Knows no meshes.
"""

from __future__ import annotations

import hashlib
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence

from probe.assets.pools.division import DIVISION, DividedObject, Part
from probe.errors import BadData

EVALUATION_SHARE = 0.3
"""Of the groups of a category that no suite has shown. Two fifths of all objects have been shown
and are for evaluation already."""


def divide(
    groups: Sequence[Sequence[str]], categories: Mapping[str, str], fixed: Mapping[str, Part]
) -> list[DividedObject]:
    """Give each group to one part.

    Args:
        groups: Near-duplicates, each group sorted; every object is in one of them.
        categories: Of each object, by id.
        fixed: The parts of objects that have one already.

    Returns:
        All objects, by id.

    Raises:
        BadData: A group has objects in both parts.
    """
    parts: dict[str, Part] = {
        group[0]: part for group in groups if (part := _fixed_part(group, fixed))
    }
    evaluated = {categories[it] for it, part in fixed.items() if part == "evaluation"}
    free = defaultdict[str, list[str]](list)
    for group in groups:
        if group[0] not in parts:
            mine = [categories[it] for it in group]
            home = next((it for it in mine if it in evaluated), mine[0])
            free[home].append(group[0])
    for category, names in free.items():
        count = 0 if category in evaluated else _for_evaluation(len(names))
        for place, name in enumerate(sorted(names, key=_luck)):
            parts[name] = "evaluation" if place < count else "train"
    return sorted(
        DividedObject(member, group[0], parts[group[0]]) for group in groups for member in group
    )


def in_parts(
    rows: Iterable[DividedObject], categories: Mapping[str, str]
) -> dict[str, frozenset[Part]]:
    """In which parts each category has objects."""
    found = defaultdict[str, set[Part]](set)
    for row in rows:
        found[categories[row.id]].add(row.part)
    return {category: frozenset(parts) for category, parts in sorted(found.items())}


def _fixed_part(group: Sequence[str], fixed: Mapping[str, Part]) -> Part | None:
    parts: dict[Part, str] = {fixed[it]: it for it in group if it in fixed}
    if len(parts) > 1:
        reason = f"{parts['train']} is for training, {parts['evaluation']} for evaluation"
        raise BadData(DIVISION, f"{reason}, and they are near-duplicates", "Change one of them")
    return next(iter(parts), None)


def _for_evaluation(groups: int) -> int:
    return max(1, round(EVALUATION_SHARE * groups)) if groups > 1 else 0


def _luck(name: str) -> bytes:
    return hashlib.sha256(f"pools {name}".encode()).digest()
