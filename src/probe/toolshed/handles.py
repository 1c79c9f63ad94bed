"""The ids that the tools give out: a look at some pixels, good while these stay as they were."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from probe.changes.change import Changes
from probe.perception.depths import tolerance
from probe.perception.things import Thing
from probe.toolshed.refusals import StaleHandle, UnknownHandle
from probe.toolshed.view import CurrentView
from probe.types import Array, Frame

MOVED = 0.003
"""Metres by which a pixel's depth has to change to count as changed."""

CHANGED_SHARE = 0.03
"""Share of changed pixels from which on a handle is stale."""

NOISY_SHARE = 0.15
"""Share of a thing's pixels that a noisy camera may take for something else in the next look."""


@dataclass(frozen=True, eq=False)
class _Look:
    """A thing as it was when its handle was last given out.

    Attributes:
        thing: It.
        pixels: Its pixels, counted row by row, shape (n,).
        depth: Of these pixels, NaN where the camera had no reading, shape (n,).
        noise: Of the depth, metres.
    """

    thing: Thing
    pixels: Array
    depth: Array
    noise: float

    @staticmethod
    def at(thing: Thing, frame: Frame) -> _Look:
        pixels = np.flatnonzero(thing.mask)
        return _Look(thing, pixels, _readings(frame, pixels), frame.depth_noise)

    def lies_in(self, mask: Array) -> bool:
        """Whether nearly all of its pixels belong to a mask."""
        share = NOISY_SHARE if self.noise > 0 else CHANGED_SHARE
        return bool(mask.ravel()[self.pixels].mean() >= 1 - share)

    def has_moved(self, frame: Frame) -> bool:
        """Whether more than a few of its pixels have another depth now."""
        change = np.abs(_readings(frame, self.pixels) - self.depth)
        least = tolerance(MOVED, self.noise, frame.depth_noise)
        still = ~(change > least)
        return float(still.mean()) < 1 - CHANGED_SHARE


def _readings(frame: Frame, pixels: Array) -> Array:
    """Depth of pixels, counted row by row, metres, shape (n,); NaN without a reading."""
    depth = frame.depth.ravel()[pixels]
    return (
        depth if frame.measured is None else np.where(frame.measured.ravel()[pixels], depth, np.nan)
    )


class Handles:
    """All handles of an episode; a thing that hasn't changed keeps the one that it has."""

    def __init__(self, *, detected: bool = True) -> None:
        """Detected: whether a handle's thing has to be among those that are detected now.

        Else it is good as long as its pixels keep their depth.
        """
        self._detected = detected
        self._looks: dict[str, _Look] = {}

    def issue(self, thing: Thing, frame: Frame) -> str:
        """The handle of a thing in a frame: the first that means it already, or else a new one."""
        name = self._known(thing, frame) or f"object_{len(self._looks) + 1}"
        self._looks[name] = _Look.at(thing, frame)
        return name

    def follow(self, changes: Changes, before: Frame, now: Frame) -> Mapping[int, str]:
        """Keep the handles of what is still about where it was, and give what has moved new ones.

        Args:
            changes: What became of everything.
            before: The table's frame before.
            now: And after.

        Returns:
            The new handles of things that had one, by the id() of their earlier sighting.
        """
        renamed: dict[int, str] = {}
        for change in changes.things:
            if change.after is None or change.fate not in ("stayed", "moved", "turned"):
                continue
            name = self._known(change.before.thing, before)
            if name is None:
                continue
            if change.fate == "stayed":
                self._looks[name] = _Look.at(change.after.thing, now)
            else:
                renamed[id(change.before)] = self.issue(change.after.thing, now)
        return renamed

    def _known(self, thing: Thing, frame: Frame) -> str | None:
        now = _Look.at(thing, frame)
        for name, look in self._looks.items():
            # Without a detector a mask is whatever was pointed at: a part isn't its whole.
            whole = self._detected or now.lies_in(look.thing.mask)
            if whole and look.lies_in(thing.mask) and not look.has_moved(frame):
                return name
        return None

    def resolve(self, name: str, view: CurrentView) -> Thing:
        """The thing that a handle means, as it shows now.

        Raises:
            UnknownHandle: It was never given out.
            StaleHandle: Its pixels have changed.
        """
        if name not in self._looks:
            raise UnknownHandle(name, list(self._looks))
        look = self._looks[name]
        # A changed depth settles it without detecting anything.
        if look.has_moved(view.frame):
            raise StaleHandle(name)
        if not self._detected:
            return look.thing
        # Thin things may move without much depth.
        thing = next((thing for thing in view.things if look.lies_in(thing.mask)), None)
        if thing is None:
            raise StaleHandle(name)
        return thing
