"""Whether objects stay where they are on a table that is rebuilt; knows nothing of how they fell.

The pile in which things settled can't tell: what balances may stay there by the luck of its sums,
and tip over on a table with the same poses and nothing else.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from probe.assets.library import Library
from probe.errors import Unsatisfiable
from probe.scene.scene import Scene
from probe.types import Pose
from probe.world.model import TIME_STEP, Item
from probe.world.pile import Pile
from probe.world.settle import REST_TIME, come_to_rest

CREEP = 0.001
"""Metres that anything may move while a finished scene is checked to be at rest."""

STILL = 0.9 * CREEP
"""Metres that any corner may move in a scene that is to be shown. What creeps by nearly CREEP here
does so by more in a model that also has the robot in it: sums differ."""

_AWAKE_TIME = 0.2


def scene_unrest(scene: Scene, library: Library) -> str | None:
    """What is wrong with a scene's rest, for people; None if it is fit to be shown.

    Stricter than suites are, whose candidates pass other checks besides: no corner may move further
    than STILL, be it that something turns or creeps steadily.
    """
    items = [
        Item(placed.instance, library[placed.object_id], library.form(placed.object_id))
        for placed in scene.objects
    ]
    pile, poses = (
        Pile(items, setup=scene.setup),
        {placed.instance: placed.pose for placed in scene.objects},
    )
    way = furthest_way(pile, poses)
    return f"something moves by {1000 * way:.1f} mm" if way > STILL else unrest(pile, poses)


def furthest_way(pile: Pile, poses: Mapping[int, Pose]) -> float:
    """How far any corner of anything moves in REST_TIME, metres."""
    stand(pile, poses)
    before = {instance: pile.corners(instance) for instance in poses}
    pile.step(REST_TIME)
    pile.stay_awake(awake=False)
    return max(
        float(np.linalg.norm(pile.corners(n) - corners, axis=1).max())
        for n, corners in before.items()
    )


def unrest(pile: Pile, poses: Mapping[int, Pose]) -> str | None:
    """What is wrong with the rest of things in these poses, for people; None if nothing moves.

    The rule of suites.
    """
    try:
        way = creep(pile, poses)
    except Unsatisfiable as failure:
        return str(failure)
    return f"something moves by {1000 * way:.1f} mm" if way > CREEP else None


def creep(pile: Pile, poses: Mapping[int, Pose]) -> float:
    """How far anything moves while it is checked to be at rest, metres.

    Raises:
        Unsatisfiable: It isn't at rest at all.
    """
    after = rest(pile, poses)
    return max(
        float(np.abs(np.subtract(after[n].position, poses[n].position)).max()) for n in poses
    )


def rest(pile: Pile, poses: Mapping[int, Pose]) -> dict[int, Pose]:
    """Put things exactly here and let them come to rest by the rules of a scene.

    Raises:
        Unsatisfiable: They don't.
    """
    stand(pile, poses)
    pile.step(_AWAKE_TIME)
    try:
        come_to_rest(pile)
    finally:
        pile.stay_awake(awake=False)
    return {instance: pile.pose(instance) for instance in pile.on_table}


def stand(pile: Pile, poses: Mapping[int, Pose]) -> None:
    """Put things exactly here and nothing else on the table; none is asleep."""
    clear(pile)
    for instance, pose in poses.items():
        pile.place(instance, pose)
    # Asleep, a thing that lost its support would hang in the air; and what tips over slowly
    # counts as asleep.
    pile.stay_awake(awake=True)


def clear(pile: Pile) -> None:
    """Take everything off the table, and the walls."""
    pile.hold()
    for item in pile.items:
        pile.park(item.instance)
    pile.set_walls(standing=False)
    # The engine overlooks that a sleeping body has been moved; one step awake tells it.
    pile.stay_awake(awake=True)
    pile.step(TIME_STEP)
    pile.stay_awake(awake=False)
