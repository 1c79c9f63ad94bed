"""Which object a mask is about, by the simulation's labels: for luck and ideals, never tools."""

from __future__ import annotations

import numpy as np

from probe.types import Array, Frame


def touched(frame: Frame, mask: Array) -> int:
    """The instance that most of a mask shows; 0 for none."""
    assert frame.labels is not None, "this needs a simulated frame"
    return int(np.bincount(frame.labels[mask], minlength=1).argmax())
