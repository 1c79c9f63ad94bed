"""What is true of a starting scene of Nested, whatever happens later."""

from __future__ import annotations

from collections.abc import Collection, Mapping

from probe.scene.scene import PlacedObject, Scene
from probe.tasks.truth import Silhouette, lies_under


def which_nested(
    scene: Scene, candidates: Collection[str], outer: int, silhouettes: Mapping[int, Silhouette]
) -> tuple[PlacedObject, int]:
    """The one candidate, by object id, beneath a thing that lies beneath the cover; and that thing.

    Args:
        scene: The table at the start.
        candidates: Object ids.
        outer: Instance of the cover.
        silhouettes: Of all objects, by instance.

    Raises:
        ValueError: Not exactly one does, or beneath several things; the question would be
            ambiguous.
    """
    known = [placed for placed in scene.objects if placed.object_id in candidates]
    numbers = {placed.instance for placed in known}
    roof = silhouettes[outer]
    between = [
        number
        for number, shape in silhouettes.items()
        if number != outer and number not in numbers and lies_under(shape, roof)
    ]
    found = [
        (placed, number)
        for placed in known
        for number in between
        if lies_under(silhouettes[placed.instance], silhouettes[number])
    ]
    if len(found) != 1:
        reason = f"lie beneath something beneath the cover, not {len(found)}"
        raise ValueError(f"Exactly one candidate should {reason}.")
    return found[0]
