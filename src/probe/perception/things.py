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
        kind: What texts call it instead of its name, if the detector tells kinds alone; else None.
    """

    name: str | None
    category: str
    colours: tuple[str, ...]
    description: str
    synonyms: tuple[str, ...] = ()
    kind: str | None = None

    @property
    def called(self) -> str:
        """What texts call it: the name, or else the description."""
        return self.told_name or self.description

    @property
    def told_name(self) -> str | None:
        """What texts give as its name; None without a name."""
        return None if self.name is None else self.kind or self.name

    @property
    def told_description(self) -> str:
        """What texts give as its description."""
        if self.name is None or self.kind is None:
            return self.description
        kind = f"{'an' if self.kind[0] in 'aeiou' else 'a'} {self.kind}"
        return f"{kind}, {' and '.join(self.colours)}" if self.colours else kind


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
