"""Moves the things of a settled table by a few millimetres and sees that it is still the same."""

from __future__ import annotations

import math

import numpy as np

from probe.assets.library import Library
from probe.generation.restored_stage import RestoredStage
from probe.generation.result import Rejected
from probe.generation.stage import Stage
from probe.scene.perturb import PoseRange, jittered
from probe.scene.scene import Scene
from probe.scene.seeds import generator

DRAWS = 12
"""How often small moves are drawn; every third time half as wide as before."""

SLACK = 0.005
"""Metres that a thing may settle in addition to how far it was moved."""

TURNED = math.radians(5)
"""How far a thing may have turned in the end; further, it has tipped or rolled."""

_LEVER = 0.1


def jitter(scene: Scene, shift: float, library: Library) -> Scene | None:
    """The scene with each object moved a little, at rest again; the scene's seed draws how.

    Args:
        scene: At rest.
        shift: Along x and along y, metres at most; things turn by as much at a lever of 10 cm.
        library: Has its objects.

    Returns:
        None if every draw made something tip, slide on or creep.
    """
    stage = RestoredStage.of(scene, library).stage
    for draw in range(DRAWS):
        reach = shift * 0.5 ** (draw // 3)
        rng = generator(scene.seed, "jitter", draw)
        moved = jittered(scene, rng, PoseRange(reach, reach / _LEVER))
        settled = _settled(moved, stage)
        if settled is not None and is_same(scene, settled, reach):
            return settled
    return None


def _settled(scene: Scene, stage: Stage) -> Scene | None:
    bare = RestoredStage(scene, stage)
    try:
        return bare.moved(stage.settle(bare.poses))
    except Rejected:
        return None


def is_same(before: Scene, after: Scene, reach: float) -> bool:
    """Whether nothing went further than it was moved and may settle."""
    for one, other in zip(before.objects, after.objects, strict=True):
        apart = np.linalg.norm(np.subtract(other.pose.position, one.pose.position))
        turned = 2 * math.acos(min(1.0, abs(float(np.dot(one.pose.wxyz, other.pose.wxyz)))))
        if apart > math.sqrt(2) * reach + SLACK or turned > TURNED + reach / _LEVER:
            return False
    return True
