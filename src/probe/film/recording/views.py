"""What agent and tools saw, in a recording: pictures, coloured points, named regions."""

from __future__ import annotations

import numpy as np

from probe.changes.sighting import Look
from probe.film.recording.stream import RecordingWriter
from probe.manipulation.terrain import lifted
from probe.types import Array, Frame

EVERY_PX = 2
"""Of how many rows and columns one becomes points."""

_POINT = 0.0009
"""Radius of a point, metres: neighbours overlap a little."""


def tell_look(writer: RecordingWriter, look: Look) -> None:
    """What the tools go by: the table and the basket as points, and the things told apart."""
    for name, frame in (("table", look.table), ("basket", look.basket)):
        points, colours = coloured_points(frame)
        writer.points(f"world/seen/{name}", points, colours, _POINT)
    things = [sighting.thing for sighting in look.things]
    numbers = np.zeros(look.table.depth.shape, int)
    for number, thing in enumerate(things, start=1):
        numbers[thing.mask] = number
    names = [f"{number} {thing.words.called}" for number, thing in enumerate(things, start=1)]
    assert look.table.rgb is not None
    writer.picture("tools/picture", look.table.rgb)
    writer.regions("tools/things", numbers, names)


def coloured_points(frame: Frame) -> tuple[Array, Array]:
    """Every so many pixels of a frame with colours as world points and sRGB, shapes (n, 3).

    Where the camera had no reading there is no point.
    """
    assert frame.rgb is not None
    known = np.ones(frame.depth.shape, bool) if frame.measured is None else frame.measured
    few = known[::EVERY_PX, ::EVERY_PX]
    return lifted(frame, known, EVERY_PX), frame.rgb[::EVERY_PX, ::EVERY_PX][few]
