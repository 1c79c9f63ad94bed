"""Which starts a stroke tries, and in what order. Moves nothing."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import islice

import numpy as np

from probe.manipulation.closedhand import SIDE
from probe.manipulation.dragging import drags
from probe.manipulation.handshape import HandShape
from probe.manipulation.pushing import PlannedPush, pushes
from probe.manipulation.target import Target
from probe.manipulation.terrain import Terrain
from probe.types import Array, Pose

_TRIED, _PRESSED = 40, 10
_VAIN = 2
_SAME_START = 0.02
_STEP, _ABOVE = 0.01, 0.001


def starts(
    target: Target,
    terrain: Terrain,
    shape: HandShape,
    along: Array,
    distance: float,
    unlike: Sequence[Pose],
    clear: bool = False,
) -> list[PlannedPush]:
    """Starts from behind; after some in vain, from above or by what stands behind it, in turns.

    What lies in a pan goes with the pan; what is flat goes with what presses on it.

    Args:
        target: What is to be pushed.
        terrain: All that is seen.
        shape: The gripper's.
        along: Unit direction, level, shape (3,).
        distance: How far, metres.
        unlike: Starts that were in vain.
        clear: Whether the hand may meet nothing else on its way.
    """

    def kept(options: Iterable[PlannedPush]) -> Iterator[PlannedPush]:
        fresh = _fresh(options, unlike)
        if not clear:
            return fresh
        others = terrain.without(target.cells).widened(SIDE)
        return (one for one in fresh if _clear(one, others, shape, along, distance))

    every = kept(pushes(target, terrain, shape, along, distance))
    above = islice(kept(drags(target, terrain, shape, along)), _PRESSED)
    if len(unlike) < _VAIN:
        behind = list(islice(every, _TRIED))
        return behind if len(behind) == _TRIED else [*behind, *above]
    if len(unlike) % 2 == 0:
        return [*above, *islice(every, _TRIED)]
    behind = list(every)
    through = [option for option in behind if option.through]
    return [*through[:_TRIED], *above, *behind[:_TRIED]]


def _fresh(options: Iterable[PlannedPush], unlike: Sequence[Pose]) -> Iterator[PlannedPush]:
    """Those that begin elsewhere than some."""
    return (one for one in options if not any(close(one, pose) for pose in unlike))


def _clear(
    one: PlannedPush, others: Terrain, shape: HandShape, along: Array, distance: float
) -> bool:
    """Whether the hand stays above all others from where it begins to where it ends."""
    steps = np.arange(0.0, one.gap + distance + _STEP, _STEP)
    hand = one.start.apply(shape.whole(0.0)) + steps[:, None, None] * along
    return bool((hand[..., 2] > others.below(hand) + _ABOVE).all())


def close(one: PlannedPush, other: Pose) -> bool:
    """Whether a push begins where another one did."""
    apart = np.subtract(one.start.position, other.position)
    return float(np.linalg.norm(apart)) < _SAME_START
