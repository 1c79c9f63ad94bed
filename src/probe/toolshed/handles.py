"""The ids that find_object gives out: a look at some pixels, good while these stay as they were."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from probe.perception.things import Thing
from probe.toolshed.refusals import StaleHandle, UnknownHandle
from probe.toolshed.view import CurrentView
from probe.types import Array, Frame

MOVED = 0.003
"""Metres by which a pixel's depth has to change to count as changed."""

CHANGED_SHARE = 0.03
"""Share of changed pixels from which on a handle is stale."""


@dataclass(frozen=True, eq=False)
class _Look:
    """A thing as it was when its handle was given out, and the depth of its pixels, shape (n,)."""

    thing: Thing
    depth: Array


class Handles:
    """All handles of an episode; they number requests, so the same thing may have several."""

    def __init__(self, *, detected: bool = True) -> None:
        """Detected: whether a handle's thing has to be among those that are detected now.

        Else it is good as long as its pixels keep their depth.
        """
        self._detected = detected
        self._looks: dict[str, _Look] = {}

    def issue(self, thing: Thing, frame: Frame) -> str:
        """A new handle for a thing in a frame."""
        name = f"object_{len(self._looks) + 1}"
        self._looks[name] = _Look(thing, frame.depth[thing.mask])
        return name

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
        if _has_moved(look, view.frame):
            raise StaleHandle(name)
        if not self._detected:
            return look.thing
        thing = _owner(look.thing.mask, view.things)
        if thing is None:
            raise StaleHandle(name)
        return thing


def _has_moved(look: _Look, frame: Frame) -> bool:
    still = np.abs(frame.depth[look.thing.mask] - look.depth) <= MOVED
    return float(still.mean()) < 1 - CHANGED_SHARE


def _owner(mask: Array, things: Sequence[Thing]) -> Thing | None:
    """The thing that takes up nearly all of a mask; thin things may move without much depth."""
    needed = (1 - CHANGED_SHARE) * np.count_nonzero(mask)
    return next((t for t in things if np.count_nonzero(t.mask & mask) >= needed), None)
