"""What is true of a starting scene of Budgeted, whatever happens later."""

from __future__ import annotations

from collections.abc import Collection, Mapping

from probe.scene.scene import PlacedObject, Scene
from probe.tasks.truth import LONGER, Silhouette, beneath_each


def which_is_so_long(
    scene: Scene,
    covers: Collection[int],
    silhouettes: Mapping[int, Silhouette],
    lengths: Mapping[str, float],
    between: tuple[float, float],
) -> tuple[PlacedObject, int]:
    """The one thing under any of the covers that has the length asked for; and its cover.

    Args:
        scene: The table at the start.
        covers: Instances.
        silhouettes: Of everything on the table, by instance.
        lengths: Longest sides in metres, by object id.
        between: The shortest and the longest candidate's length, metres.

    Raises:
        ValueError: Not exactly one thing has it, all others being clearly shorter.
    """
    low, high = between
    beneath = beneath_each(covers, silhouettes)
    found = [(scene[item], cover) for cover, under in beneath.items() for item in under]
    sizes = [lengths[placed.object_id] for placed, _ in found]
    right = [each for each, size in zip(found, sizes, strict=True) if low <= size <= high]
    unclear = [size for size in sizes if low / LONGER < size and not low <= size <= high]
    if len(right) != 1 or unclear:
        raise ValueError(
            f"Exactly one thing under the covers should be so long, not {len(right)}; "
            f"{len(unclear)} more are nearly so long."
        )
    return right[0]
