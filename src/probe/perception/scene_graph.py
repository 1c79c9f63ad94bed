"""What can be told of a whole scene: things, how they lie, which places are full. Plain values."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, NamedTuple, Protocol

from probe.perception.things import Words
from probe.types import Frame

Side = Literal["left_of", "right_of", "above", "below"]
"""As seen in the picture."""

Contact = Literal["on", "covering", "touching"]

Kind = Literal[Side, Contact]
"""How one thing is related to another."""

Region = Literal[
    "top left", "top centre", "top right",
    "middle left", "middle centre", "middle right",
    "bottom left", "bottom centre", "bottom right",
]  # fmt: skip
"""Ninths of the picture."""


class Relation(NamedTuple):
    """One thing's relation to another; both by their place in the list, from 0."""

    first: int
    kind: Kind
    second: int


@dataclass(frozen=True)
class GraphEntry:
    """One thing in words.

    Attributes:
        words: What can be said of it.
        point_px: (u, v) of a pixel on it.
        box_px: First and last column and row: left, top, right, bottom.
    """

    words: Words
    point_px: tuple[int, int]
    box_px: tuple[int, int, int, int]


@dataclass(frozen=True)
class SceneGraph:
    """A scene in words.

    Attributes:
        entries: Things, by point from top to bottom, then left to right.
        relations: Between them.
        cluttered, clear: Parts of the picture.
    """

    entries: tuple[GraphEntry, ...]
    relations: tuple[Relation, ...]
    cluttered: tuple[Region, ...]
    clear: tuple[Region, ...]


class SceneDescriber(Protocol):
    """Tells a frame that has colours as a scene graph."""

    def tell(self, frame: Frame) -> SceneGraph:
        """The scene in words.

        Raises:
            UnusableReply: A model was asked and its reply makes no sense.
            ModelFailed: A model was asked and no reply came.
        """
        ...
