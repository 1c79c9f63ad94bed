"""By how much higher the larger of two marked things lies, as a depth camera sees it."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from probe.generation.scene_view import SceneView
from probe.generation.size_cues import Windows
from probe.scene.scene import Scene
from probe.types import Array


class DepthCues(NamedTuple):
    """What the larger thing has over the smaller one; negative where it lags.

    Attributes:
        cover_height: Natural logarithm of the ratio of the heights to which their covers reach.
        height: Natural logarithm of the ratio of the heights to which what shows of the things
            themselves reaches.
    """

    cover_height: float
    height: float


WINDOWS: Windows = ((math.log(1.05), math.log(1.8)),) * 2
"""Of DepthCues: where amounts differ, they tell which is larger."""

RIMS = 0.003
"""Metres by which the lowest points of the two covers may differ: where one of them touches the
table nowhere, it lay over the larger thing in 27 of 28 tasks."""

_LOWEST = 0.002
"""Metres; what lies flatter counts as so high, as its depth is measured no better."""


@dataclass(frozen=True)
class DepthLook:
    """What a depth camera sees where something lies beneath a cover.

    Attributes:
        cover_height: Height above the table of its cover's highest point, metres.
        height: Height above the table of the highest point that shows of the thing, metres.
        cover_low: Height above the table of its cover's lowest point, metres.
    """

    cover_height: float
    height: float
    cover_low: float

    @classmethod
    def of(cls, view: SceneView, scene: Scene, labels: Array, number: int) -> DepthLook:
        """What is seen of an instance, and of what hides most of it.

        Args:
            view: A view of the scene's objects.
            scene: The table.
            labels: Instance numbers of its picture, shape (h, w).
            number: A partly hidden instance.

        Raises:
            ValueError: Nothing hides any of it.
        """
        cover = scene[_hiding(labels, view.silhouettes(scene, [number])[number].mask, number)]
        low, high = view.reach_of(cover)
        shown = view.top_shown(scene, labels, number)
        return cls(max(high, _LOWEST), max(shown, _LOWEST), low)


def leads_of(larger: DepthLook, smaller: DepthLook) -> DepthCues:
    """What the larger thing has over the smaller one."""
    return DepthCues(
        math.log(larger.cover_height / smaller.cover_height),
        math.log(larger.height / smaller.height),
    )


def rims_tell(one: DepthLook, other: DepthLook) -> bool:
    """Whether one cover lies clear of the table, or both do and not equally high."""
    return abs(one.cover_low - other.cover_low) > RIMS


def _hiding(labels: Array, outline: Array, number: int) -> int:
    """The instance that hides most of one, whose outline it would have alone is this mask."""
    over = labels[outline]
    numbers, counts = np.unique(over[(over != number) & (over != 0)], return_counts=True)
    if not len(numbers):
        raise ValueError(f"nothing hides any of instance {number}")
    return int(numbers[np.argmax(counts)])
