"""How much of each object shows: counted on label pictures, by ghost removal."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from probe.types import Array


@dataclass(frozen=True)
class Visibility:
    """Pixels of an object in the picture, and in the same picture if it stood there alone."""

    visible_px: int
    alone_px: int

    @property
    def fraction(self) -> float:
        """Visible share of the object, 0 to 1; 0 for an object outside the picture."""
        return self.visible_px / self.alone_px if self.alone_px else 0.0


def visibilities(labels: Array, outlines: Mapping[int, Array]) -> dict[int, Visibility]:
    """Visibility by instance.

    Args:
        labels: Instance numbers, shape (h, w).
        outlines: For each instance its mask when everything else is taken away, shape (h, w).
    """
    visible = np.bincount(labels.ravel(), minlength=max(outlines, default=0) + 1)
    return {
        instance: Visibility(int(visible[instance]), int(np.count_nonzero(mask)))
        for instance, mask in outlines.items()
    }
