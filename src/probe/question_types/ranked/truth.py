"""What is true of a starting scene of Ranked, whatever happens later."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from itertools import pairwise

from probe.question_types.ranked.rules import RANKS
from probe.scene.scene import PlacedObject, Scene
from probe.tasks.truth import LONGER, Silhouette, beneath_each
from probe.tasks.type_rules import Form


def has_rank(form: Form, length: float, others: Sequence[float]) -> bool:
    """Whether one of three things has the asked rank, each being clearly longer than the next.

    Args:
        form: One of RANKS.
        length: Of the one, metres.
        others: Of the two others.
    """
    order = sorted([length, *others], reverse=True)
    return _clear(order) and order[RANKS.index(form)] == length


def longest_first(
    scene: Scene,
    covers: Collection[int],
    silhouettes: Mapping[int, Silhouette],
    lengths: Mapping[str, float],
) -> tuple[tuple[PlacedObject, int], ...]:
    """What lies under each of the covers, and that cover, the longest first.

    Args:
        scene: The table at the start.
        covers: Instances.
        silhouettes: Of everything on the table, by instance.
        lengths: Longest sides in metres, by object id.

    Raises:
        ValueError: Not exactly one thing lies under each, or two are about as long.
    """
    beneath = beneath_each(covers, silhouettes)
    if len(beneath) != len(RANKS) or any(len(under) != 1 for under in beneath.values()):
        counts = [len(under) for under in beneath.values()]
        raise ValueError(f"Exactly one thing should lie under each of three covers, not {counts}.")
    found = [(scene[under[0]], cover) for cover, under in beneath.items()]
    found.sort(key=lambda each: lengths[each[0].object_id], reverse=True)
    if not _clear([lengths[placed.object_id] for placed, _ in found]):
        raise ValueError("Two of the things under the covers are about equally long.")
    return tuple(found)


def _clear(order: Sequence[float]) -> bool:
    return all(longer >= LONGER * shorter for longer, shorter in pairwise(order))
