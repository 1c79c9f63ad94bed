"""Colours of a look at the table, which simulation paints when somebody asks for them."""

from __future__ import annotations

from dataclasses import replace

from probe.station.station import Station
from probe.types import Frame


def paintable(station: Station, frame: Frame) -> Frame:
    """A look from which coloured() can make one in colour, even after the table has changed.

    A camera has to take it now; simulation remembers what stood where.

    Args:
        station: Looks.
        frame: The table as it is now.
    """
    held = frame.rgb is not None or frame.painter is not None
    return frame if held else station.observe(rgb=True)


def coloured(frame: Frame) -> Frame:
    """A look with its colours.

    Raises:
        ValueError: It has none, and can't be painted; see paintable().
    """
    if frame.rgb is not None:
        return frame
    if frame.painter is None:
        raise ValueError("paintable() before coloured()")
    return replace(frame, rgb=frame.painter(), painter=None)


def in_colour(station: Station, frame: Frame) -> Frame:
    """The table as it is now, which a look shows, in colour."""
    return coloured(paintable(station, frame))
