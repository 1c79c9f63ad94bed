"""What is true of a starting scene of Decoys, whatever happens later."""

from __future__ import annotations

from collections.abc import Collection, Mapping

from probe.scene.scene import PlacedObject, Scene
from probe.tasks.truth import Silhouette, lies_under


def which_under_any(
    scene: Scene,
    candidates: Collection[str],
    covers: Collection[int],
    silhouettes: Mapping[int, Silhouette],
) -> tuple[PlacedObject, int]:
    """The one candidate, by object id, that lies under one of the covers; and that cover.

    Args:
        scene: The table at the start.
        candidates: Object ids.
        covers: Instances.
        silhouettes: Of the covers and of the candidates on the table, by instance.

    Raises:
        ValueError: Not exactly one does, or under several; the question would be ambiguous.
    """
    known = [placed for placed in scene.objects if placed.object_id in candidates]
    found = [
        (placed, cover)
        for placed in known
        for cover in sorted(covers)
        if lies_under(silhouettes[placed.instance], silhouettes[cover])
    ]
    if len(found) != 1:
        reason = f"lie under one of the covers, not {len(found)}"
        raise ValueError(f"Exactly one candidate should {reason}.")
    return found[0]
