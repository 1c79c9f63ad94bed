"""What can be said of a thing by the colours and the outline of its pixels. Knows no objects."""

from __future__ import annotations

import numpy as np

from probe.assets.colour.names import Colour, main_colours
from probe.perception.outline import shape_word
from probe.types import Array, Frame


def look_of(mask: Array, frame: Frame) -> tuple[tuple[Colour, ...], str]:
    """Main colours of a mask's pixels, and a phrase on them and its shape.

    Args:
        mask: Visible pixels, bool, shape (h, w).
        frame: Must have colours.
    """
    assert frame.rgb is not None
    colours = main_colours(frame.rgb[mask])
    rows, columns = np.nonzero(mask)
    centres = np.column_stack([columns, rows]) + 0.5
    heights = frame.camera.lift(centres, frame.depth[rows, columns])[:, 2]
    return colours, f"{' and '.join(colours)}, what shows is {shape_word(mask, heights)}"
