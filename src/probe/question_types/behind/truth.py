"""What is true of a starting scene of Behind, whatever happens later."""

from __future__ import annotations

from collections.abc import Collection, Mapping

from probe.scene.scene import PlacedObject, Scene
from probe.tasks.truth import Silhouette, covered_share
from probe.types import Camera

BEHIND_SHARE = 0.7
"""Share of an object's silhouette that lies within that of what it is behind."""


def which_behind(
    scene: Scene,
    candidates: Collection[str],
    occluder: int,
    silhouettes: Mapping[int, Silhouette],
    camera: Camera,
) -> PlacedObject:
    """The one candidate, by object id, that stands behind the occluder.

    Args:
        scene: The table at the start.
        candidates: Object ids.
        occluder: Instance of what stands in front.
        silhouettes: Of the occluder and of the candidates on the table, by instance, as the
            camera sees each alone.
        camera: The task's.

    Raises:
        ValueError: Not exactly one does; the question would be ambiguous.
    """
    known = [placed for placed in scene.objects if placed.object_id in candidates]
    found = [it for it in known if _is_behind(scene, it.instance, occluder, silhouettes, camera)]
    if len(found) != 1:
        raise ValueError(f"Exactly one candidate should be behind it, not {len(found)}.")
    return found[0]


def _is_behind(
    scene: Scene,
    item: int,
    occluder: int,
    silhouettes: Mapping[int, Silhouette],
    camera: Camera,
) -> bool:
    """Whether most of an object's silhouette is within the occluder's, and it is farther away."""
    within = covered_share(silhouettes[item], silhouettes[occluder])
    far, near = (distance(scene[number], camera) for number in (item, occluder))
    return within >= BEHIND_SHARE and far > near


def distance(placed: PlacedObject, camera: Camera) -> float:
    """How far an object stands from a camera along the table, metres."""
    ex, ey, _ = camera.world_from_camera.position
    x, y, _ = placed.pose.position
    return ((x - ex) ** 2 + (y - ey) ** 2) ** 0.5
