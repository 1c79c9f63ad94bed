"""Which starts a stroke tries, and in what order. Moves nothing."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import islice

import numpy as np

from probe.manipulation.dragging import drags
from probe.manipulation.handshape import HandShape
from probe.manipulation.pushing import PlannedPush, pushes
from probe.manipulation.target import Target
from probe.manipulation.terrain import Terrain
from probe.types import Array, Pose

_TRIED, _PRESSED = 40, 10
_VAIN = 2
_SAME_START = 0.02


def starts(
    target: Target,
    terrain: Terrain,
    shape: HandShape,
    along: Array,
    distance: float,
    unlike: Sequence[Pose],
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
    """
    every = _fresh(pushes(target, terrain, shape, along, distance), unlike)
    above = islice(_fresh(drags(target, terrain, shape, along), unlike), _PRESSED)
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


def close(one: PlannedPush, other: Pose) -> bool:
    """Whether a push begins where another one did."""
    apart = np.subtract(one.start.position, other.position)
    return float(np.linalg.norm(apart)) < _SAME_START
