"""What perception hands on: things in a picture, in words and pixels; nothing that tells identity.

Knows no instance numbers and no catalogue ids, so nothing built on it can pass them on.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from probe.perception.outline import box_of, interior_point
from probe.types import Array, Frame


@dataclass(frozen=True)
class Words:
    """What can be said of an object from its visible part.

    Attributes:
        name: Short name; None if too little shows to tell what it is.
        category: Common noun; empty without a name.
        colours: Main colours, largest first.
        description: One sentence or phrase.
        synonyms: Other names that it goes by; none of catalogues.
    """

    name: str | None
    category: str
    colours: tuple[str, ...]
    description: str
    synonyms: tuple[str, ...] = ()

    @property
    def called(self) -> str:
        """The name, or else the description."""
        return self.name or self.description


@dataclass(frozen=True, eq=False)
class Thing:
    """One thing that shows in a picture.

    Attributes:
        mask: Its visible pixels, bool, shape (h, w).
        point_px: (u, v) of its most interior visible pixel.
        box_px: First and last column and row it shows in: left, top, right, bottom.
        words: What can be said of it.
    """

    mask: Array
    point_px: tuple[int, int]
    box_px: tuple[int, int, int, int]
    words: Words

    @staticmethod
    def of(mask: Array, words: Words) -> Thing:
        """What a mask that isn't empty shows."""
        return Thing(mask, interior_point(mask), box_of(mask), words)

    @property
    def nameable(self) -> bool:
        """Whether enough shows to say what it is."""
        return self.words.name is not None


class Detector(Protocol):
    """Finds things in a frame; the oracle here, a model elsewhere."""

    def needs_rgb(self, frame: Frame) -> bool:
        """Whether it takes the frame's colours to detect what it shows."""
        ...

    def detect(self, frame: Frame) -> tuple[Thing, ...]:
        """Things that show, sorted by their point from top to bottom, then left to right."""
        ...
