"""Lets a pile come to rest by the rules of a scene, or says that it won't."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from probe.errors import Unsatisfiable
from probe.scene.sampling import Drop, draw_drop
from probe.scene.scene import PlacedObject
from probe.scene.setup import UR5_TABLE, Setup
from probe.types import Array
from probe.world.model import Item
from probe.world.pile import SINK_LIMIT, Pile

SETTLING_TIME = 4.0
"""Seconds of simulated time after which a pile that doesn't sleep is looked at all the same: what
still creeps or rolls then is found by the check of its rest, and gets up to 8 s more there. (What
sleeps would sleep for the rest of 30 s.)"""

REST_TIME = 2.0
"""Seconds, with the engine's sleeping off, in which nothing may move further than REST_LIMIT."""

REST_LIMIT = 0.001
"""Metres."""

_FALL_TIME = 0.6
_SLOW = 0.1
_RESPOTS = 3
_REST_CHECKS = 4


def settle(
    items: Sequence[Item],
    drops: Mapping[int, Drop],
    rng: np.random.Generator,
    setup: Setup = UR5_TABLE,
) -> tuple[PlacedObject, ...]:
    """Drop items in the given order and let them come to rest.

    Those that leave the area are dropped again at another spot, three times at most.

    Args:
        items: What falls, in this order.
        drops: How each falls, by instance.
        rng: For the spots of those that are dropped again.
        setup: The table.

    Raises:
        Unsatisfiable: Something keeps leaving the table, or never rests.
    """
    pile = Pile(items, setup=setup)
    waiting = [item.instance for item in items]
    for respot in range(_RESPOTS + 1):
        pile.set_walls(standing=True)
        for instance in waiting:
            pile.drop(instance, drops[instance] if respot == 0 else draw_drop(rng))
            pile.fall(_FALL_TIME, slow=_SLOW)
        pile.set_walls(standing=False)
        pile.fall(SETTLING_TIME)
        waiting = [item.instance for item in items if not pile.is_inside(item.instance)]
        if not waiting:
            break
        for instance in waiting:
            pile.park(instance)
    if waiting:
        names = ", ".join(item.spec.name for item in items if item.instance in waiting)
        raise Unsatisfiable(f"These keep leaving the table: {names}.")
    come_to_rest(pile)
    return tuple(
        PlacedObject(item.instance, item.spec.id, pile.pose(item.instance))
        for item in sorted(items, key=lambda item: item.instance)
    )


def come_to_rest(pile: Pile) -> None:
    """Check that nothing creeps once the engine's sleeping is off; give it more time if it does.

    What is checked is what a scene keeps: poses alone, without speeds or the solver's memory. The
    pile is left in the poses from which the check that it passed set out.

    Raises:
        Unsatisfiable: Something still moves, sinks in or has left the table.
    """
    pile.stay_awake(awake=True)
    moved, before = float("inf"), pile.data.qpos.copy()
    for _ in range(_REST_CHECKS):
        pile.freeze()
        before, corners = pile.data.qpos.copy(), _corners(pile)
        pile.step(REST_TIME)
        moved = float(np.abs(_corners(pile) - corners).max())
        if moved <= REST_LIMIT:
            break
    if moved > REST_LIMIT:
        raise Unsatisfiable(f"Something still creeps: {moved * 1000:.1f} mm in {REST_TIME:.0f} s.")
    if (depth := pile.penetration()) > SINK_LIMIT:
        raise Unsatisfiable(f"Two objects overlap by {depth * 1000:.1f} mm.")
    if not all(pile.is_inside(instance) for instance in pile.on_table):
        raise Unsatisfiable("Something left the table while the rest was checked.")
    pile.data.qpos[:] = before
    pile.freeze()


def _corners(pile: Pile) -> Array:
    return np.stack([pile.bounds(item.instance) for item in pile.items])
