"""What is true of a starting scene. Pure functions of it: nothing that happens later matters."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass

import numpy as np

from probe.scene.scene import PlacedObject, Scene
from probe.types import Array

COVERED_SHARE = 0.7
"""Share of an object's silhouette that lies within the silhouette of what it is under."""


@dataclass(frozen=True, eq=False)
class Silhouette:
    """An object of the starting scene as if it stood there alone.

    Attributes:
        mask: Where it shows in the top-down picture, bool, shape (h, w).
        top: Height of its highest point in metres.
    """

    mask: Array
    top: float


def how_many(scene: Scene, object_id: str) -> int:
    """Count: instances of an object on the table."""
    return sum(placed.object_id == object_id for placed in scene.objects)


def which_on_table(scene: Scene, candidates: Collection[str]) -> PlacedObject:
    """Find: the one candidate, by object id, that is on the table.

    Raises:
        ValueError: Not exactly one is; the question would be ambiguous.
    """
    return _only([placed for placed in scene.objects if placed.object_id in candidates])


def which_beneath(
    scene: Scene, candidates: Collection[str], cover: int, silhouettes: Mapping[int, Silhouette]
) -> PlacedObject:
    """Beneath: the one candidate, by object id, that lies under the cover.

    Args:
        scene: The table at the start.
        candidates: Object ids.
        cover: Instance of the cover.
        silhouettes: Of the cover and of the candidates that are on the table, by instance.

    Raises:
        ValueError: Not exactly one does; the question would be ambiguous.
    """
    known = [placed for placed in scene.objects if placed.object_id in candidates]
    roof = silhouettes[cover]
    return _only([placed for placed in known if lies_under(silhouettes[placed.instance], roof)])


def lies_under(item: Silhouette, cover: Silhouette) -> bool:
    """Whether most of an object's silhouette is within the cover's and its top is lower."""
    return covered_share(item, cover) >= COVERED_SHARE and item.top < cover.top


def covered_share(item: Silhouette, cover: Silhouette) -> float:
    """Share of an object's silhouette within the cover's, 0 to 1."""
    whole = np.count_nonzero(item.mask)
    return float(np.count_nonzero(item.mask & cover.mask) / whole) if whole else 0.0


def _only(found: list[PlacedObject]) -> PlacedObject:
    if len(found) != 1:
        raise ValueError(f"Exactly one candidate should answer the question, not {len(found)}.")
    return found[0]
