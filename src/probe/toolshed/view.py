"""What the camera sees now; colours are drawn and things detected when somebody asks."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from probe.changes.change import Changes
from probe.changes.sighting import Look, Sighting, sightings
from probe.perception.relief import AROUND
from probe.perception.things import Detector, Thing
from probe.scene.setup import Basket
from probe.station.colours import in_colour
from probe.station.station import Station
from probe.types import Array, Frame, Pose


class CurrentView:
    """The current frame of a station, until the next one is shown."""

    def __init__(
        self, station: Station, detector: Detector, basket: Basket, *, guessed: bool = False
    ) -> None:
        """Look once. Guessed: whether the same thing may be outlined otherwise next time."""
        self._guessed = guessed
        self._station = station
        self._basket = basket
        self._detector = detector
        self._frame = station.observe(rgb=False)
        self._things: tuple[Thing, ...] | None = None
        self._look: Look | None = None
        self._buried: tuple[Sighting, ...] = ()
        self._missing: tuple[Sighting, ...] = ()

    def show(self, frame: Frame) -> None:
        """The table may have changed: this is what it looks like from now on."""
        self._frame, self._things, self._look = frame, None, None

    @property
    def frame(self) -> Frame:
        """Depth and labels; colours only if they have been drawn already."""
        return self._frame

    @property
    def rgb(self) -> Array:
        """The picture, sRGB uint8, shape (h, w, 3)."""
        rgb = self.coloured.rgb
        assert rgb is not None
        return rgb

    @property
    def coloured(self) -> Frame:
        """The current frame with its colours."""
        self._frame = in_colour(self._station, self._frame)
        return self._frame

    @property
    def things(self) -> tuple[Thing, ...]:
        """What perception makes of it."""
        if self._things is None:
            needed = self._frame.rgb is None and self._detector.needs_rgb(self._frame)
            self._things = self._detector.detect(self.coloured if needed else self._frame)
        return self._things

    @property
    def look(self) -> Look:
        """What shows on the table and in the basket."""
        if self._look is None:
            table = self.coloured
            basket = self._station.look_into_basket(rgb=True)
            below = sightings(basket, self._detector.detect(_from_its_floor(basket, self._basket)))
            inside = tuple(s for s in below if self._basket.holds(*s.middle[:2]))
            beside = tuple(s for s in below if s not in inside and not _in_view(table, s.middle))
            here = sightings(table, self.things)
            self._look = Look(
                table, here, basket, inside, beside, self._guessed, self._buried, self._missing
            )
        return self._look

    def remember(self, changes: Changes) -> None:
        """From now on a look also tells what these changes have left unseen."""
        self._buried, self._missing = changes.buried, changes.missing
        if self._look is not None:
            self._look = replace(self._look, buried=self._buried, missing=self._missing)


def _from_its_floor(frame: Frame, basket: Basket) -> Frame:
    """The frame as if the basket's floor lay where the table's top does: detectors look there."""
    *aside, height = basket.position
    reach = max(abs(middle) + size / 2 for middle, size in zip(aside, basket.size, strict=False))
    shift = np.array([*(aside if reach > AROUND else (0.0, 0.0)), height])
    if not shift.any():
        return frame
    pose = frame.camera.world_from_camera
    there = Pose.of(np.array(pose.position) - shift, np.array(pose.wxyz))
    return replace(frame, camera=replace(frame.camera, world_from_camera=there))


def _in_view(frame: Frame, point: Array) -> bool:
    """Whether a frame's picture has a place for a point, world, metres, shape (3,)."""
    u, v = frame.camera.project(point[None])[0, :2]
    height, width = frame.depth.shape
    return bool(0 <= u < width and 0 <= v < height)
